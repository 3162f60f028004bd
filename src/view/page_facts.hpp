// Describes a light field for the page, and makes its views as one image (a quilt) from the panel's image.
//
// With a whole number of pixels per lens, views are the panel's own pixels. For slanted, hexagonal and fractional lenses,
// `EyeSampler` computes what eyes in all distinguishable directions see, with one sample per pixel and reduced resolution.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/rendered.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/view_phases.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "view/view_axes.hpp"

namespace lippmann {

enum class PanelPicture {
  kIntegral,  ///< one cell of pixels per lens; a cell has one pixel of each view
  kQuilt,     ///< the image is the quilt of the views
  kOwn,       ///< the page cannot derive the image, and loads it
};

struct PageFrame {
  std::string label;
  FrameFacts facts;
};

struct PageFacts {
  std::string title;
  ViewGrid grid;
  ViewGrid tiles;  ///< arrangement of the views in the quilt, view 0 at the bottom left
  Vec2i view_size{0, 0};
  Window window;  ///< part of the plane z = 0 that every view shows
  ViewAxes axes;
  /// Whether a sample of a view covers a whole lens horizontally (across) or vertically (up).
  bool lens_samples_across = false, lens_samples_up = false;
  PanelPicture panel = PanelPicture::kOwn;
  Vec2i panel_size{0, 0};
  std::optional<ViewPhases> phases;  ///< view that each sub-pixel shows; none without a calibration
  Vec3d eye_mm{0.0};
  double depth_budget_mm = 0.0;
  bool has_depth = false;
  bool has_provenance = false;      ///< the origin of every pixel (Provenance) is known
  double disparity_scale_mm = 1.0;  ///< scale of the disparity codes (view/disparity_codes.hpp)
  double frames_per_second = 25.0;
  std::vector<PageFrame> frames;
  std::string assumption;
};

/// Members that do not follow from the optics (title, frames, depth, frame rate) have their defaults.
PageFacts page_facts(const Optics& optics);

Viewer eye_of_view(const PageFacts& facts, int view);

/// Returns a quilt in sRGB codes with facts.tiles tiles of facts.view_size. crosstalk_px: sigma of the blur between
/// neighbouring views (optics/crosstalk.hpp); ignored for views that are the panel's own pixels. Throws Error naming `where` if
/// the image does not have the size of the optics.
Image8 views_quilt(const RenderedPanel& rendered, const PageFacts& facts, const ThreadPool& pool, const std::string& where,
                   double crosstalk_px = 0.0);

}  // namespace lippmann

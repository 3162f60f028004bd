// What a page is told of a light field, and its views in one picture (a quilt), made of what the panel shows.
//
// Views are the panel's own pixels where it has views of whole pixels; of slanted, hexagonal and fractional lenses they are
// what `EyeSampler` shows to eyes in as many directions as can be told apart, one sample a pixel and no more pixels than a
// second or two make.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "layout/rendered.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/view_phases.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "view/view_axes.hpp"

namespace lippmann {

/// How the pixels of the panel's picture follow from those of the views.
enum class PanelPicture {
  kIntegral,  ///< cells of grid.columns x grid.rows pixels, one from each view, turned round (layout/view_layout.hpp)
  kQuilt,     ///< the quilt of the views itself
  kOwn,       ///< they do not: it is a picture of its own
};

struct PageFrame {
  std::string label;
  FrameFacts facts;
};

struct PageFacts {
  std::string title;
  ViewGrid grid;          ///< how many views there are across and up
  ViewGrid tiles;         ///< how the quilt holds them, view 0 at the bottom left
  Vec2i view_size{0, 0};  ///< pixels
  Window window;          ///< that every view shows, in z = 0
  ViewAxes axes;
  bool lens_samples_across = false, lens_samples_up = false;  ///< a pixel of a view is what a whole lens shows
  PanelPicture panel = PanelPicture::kOwn;
  Vec2i panel_size{0, 0};            ///< pixels of the panel's picture
  std::optional<ViewPhases> phases;  ///< of the panel's sub-pixels, where they have any
  Vec3d eye_mm{0.0};                 ///< where the display is meant to be seen from
  double depth_budget_mm = 0.0;
  bool has_depth = false;
  bool has_provenance = false;      ///< of every pixel of the views
  double disparity_scale_mm = 1.0;  ///< the scale of codes (view/disparity_codes.hpp)
  double frames_per_second = 25.0;
  std::vector<PageFrame> frames;
  std::string assumption;  ///< what is not known of the cameras; empty: nothing
};

/// The facts of a light field behind these optics; what is not theirs (title, frames, depth, frame rate) is as by default.
PageFacts page_facts(const Optics& optics);

/// The eye that a view of the page stands for.
Viewer eye_of_view(const PageFacts& facts, int view);

/// sRGB codes; facts.tiles of facts.view_size. `where` is named by the Error for a picture that is not of the optics' size.
/// crosstalk_px: a sigma as of optics/crosstalk.hpp, with which eyes look; of views of whole pixels, which no eye looks at, it
/// is not used.
Image8 views_quilt(const RenderedPanel& rendered, const PageFacts& facts, const ThreadPool& pool, const std::string& where,
                   double crosstalk_px = 0.0);

}  // namespace lippmann

// A light field as a page shows it: what it is in figures, and of every frame its views in one picture (a quilt), how far
// points move from view to view where depth is known, and what the panel shows.
//
// Whatever `find_light_field_frames` reads. Views are the panel's own pixels where it has views of whole pixels; of slanted,
// hexagonal and fractional lenses they are what `EyeSampler` shows to eyes in as many directions as can be told apart, one
// sample a pixel and no more pixels than a second or two make.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layout/rendered.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/light_field_frames.hpp"
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
  ViewGrid grid;          ///< of the views
  ViewGrid tiles;         ///< of the quilt, view 0 at the bottom left
  Vec2i view_size{0, 0};  ///< pixels
  Window window;          ///< that every view shows, in z = 0
  ViewAxes axes;
  bool lens_samples_across = false, lens_samples_up = false;  ///< a pixel of a view is what a whole lens shows
  PanelPicture panel = PanelPicture::kOwn;
  Vec2i panel_size{0, 0};               ///< pixels of the panel's picture
  std::optional<SlantedPanel> slanted;  ///< the panel, where that is its picture
  Vec3d eye_mm{0.0};                    ///< where the display is meant to be seen from
  double depth_budget_mm = 0.0;
  bool has_depth = false;
  double disparity_scale_mm = 1.0;  ///< of the codes (view/disparity_codes.hpp)
  double frames_per_second = 25.0;
  std::vector<PageFrame> frames;
  std::string assumption;  ///< what is not known of the cameras; empty: nothing
};

class PageField {
 public:
  /// Throws Error naming the file, or the flag that has to say what nothing else says; depth that cannot be read is left out
  /// with a warning. Files that lead out of the folder that
  /// is shown are refused when they are read.
  PageField(std::filesystem::path in, LightFieldHints hints, const Context& context);

  const PageFacts& facts() const { return facts_; }

  // These are of the frame of that index, below facts().frames.size(). All throw Error naming the file; thread-safe.

  /// sRGB codes; facts().tiles of facts().view_size.
  Image8 quilt(std::size_t frame) const;
  /// Likewise, codes of disparity. Needs facts().has_depth.
  Image8 disparities(std::size_t frame) const;
  /// sRGB codes of facts().panel_size.
  Image8 panel(std::size_t frame) const;

 private:
  RenderedPanel read(std::size_t frame) const;
  bool has_depth_beside(std::size_t frame) const;
  Image seen_by_eyes(const RenderedPanel& rendered) const;

  LightFieldHints hints_;
  LightFieldFrames frames_;
  std::filesystem::path root_;
  PageFacts facts_;
  ThreadPool pool_;
};

}  // namespace lippmann

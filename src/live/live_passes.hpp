// Makes the images of a frame in passes: a coarse light field at once, a draft with few paths, and the image of `lippmann
// render`.
//
// Each pass returns early, without an image, if the context is cancelled.
#pragma once

#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/image/image.hpp"
#include "live/live_stage.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Path samples per pixel of a draft.
inline constexpr int kDraftSamples = 8;

struct LivePictures {
  Vec2i view_size{0, 0};
  Image8 views;                 ///< the views in sRGB codes, as a quilt of facts.tiles tiles
  std::optional<Image8> panel;  ///< the panel's image; none: not known yet
};

/// Returns images with few pixels, each with one sample or a few paths. Returns nullopt for the test pattern, which has no
/// scene.
std::optional<LivePictures> coarse_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// Returns images with fewer samples per pixel than the render. Returns nullopt if they would not be faster to make.
std::optional<LivePictures> draft_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// Returns the codes of the images that a render with 8 bits per sample would write. Throws Error for parameters that
/// contradict each other.
std::optional<LivePictures> finished_pictures(LiveStage& live, const PageFacts& facts, int frame);

/// Returns the disparity codes (view/disparity_codes.hpp) of the views as a quilt, for views of view_size. Needs
/// facts.has_depth.
Image8 depth_picture(LiveStage& live, const PageFacts& facts, Vec2i view_size, int frame);

}  // namespace lippmann

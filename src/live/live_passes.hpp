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
  Image8 views;                 ///< sRGB codes; a quilt of facts.tiles of view_size
  std::optional<Image8> panel;  ///< the panel's image; none: not known yet
};

/// Returns images with few pixels, with one sample or a few paths each. None for the test pattern, which has no scene.
std::optional<LivePictures> coarse_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// Returns images with fewer samples than the render. None if that would not be faster.
std::optional<LivePictures> draft_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// Returns the codes of a render's 8-bit images. Throws Error for parameters that contradict each other.
std::optional<LivePictures> finished_pictures(LiveStage& live, const PageFacts& facts, int frame);

/// Returns the disparity codes (view/disparity_codes.hpp) of views of that size, as a quilt. Needs facts.has_depth.
Image8 depth_picture(LiveStage& live, const PageFacts& facts, Vec2i view_size, int frame);

}  // namespace lippmann

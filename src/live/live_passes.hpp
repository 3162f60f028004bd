// Makes the images of a frame in passes: a coarse light field, a draft with few paths, and the image of `lippmann
// render`. Each pass returns early, without an image, if the context is cancelled.
#pragma once

#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/image/image.hpp"
#include "live/live_stage.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

inline constexpr int kDraftSamples = 8;

struct LivePictures {
  Vec2i view_size{0, 0};
  Image8 views;  ///< views in sRGB codes, as a quilt with facts.tiles tiles
  std::optional<Image8> panel;
};

/// Returns images of few pixels, or nullopt for the test pattern, which has no scene.
std::optional<LivePictures> coarse_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// Returns images with fewer samples per pixel, or nullopt if they would not be faster.
std::optional<LivePictures> draft_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// Returns the 8-bit images that a render would write. Throws Error if parameters contradict each other.
std::optional<LivePictures> finished_pictures(LiveStage& live, const PageFacts& facts, int frame);

/// Returns the disparity codes (view/disparity_codes.hpp) of the views as a quilt. Requires facts.has_depth.
Image8 depth_picture(LiveStage& live, const PageFacts& facts, Vec2i view_size, int frame);

}  // namespace lippmann

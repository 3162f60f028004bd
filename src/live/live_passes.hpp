// The pictures of a frame, one after the other: a coarse light field at once, a draft of few paths, and what `lippmann
// render` makes.
//
// Each pass ends early, without a picture, when the context is cancelled.
#pragma once

#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/image/image.hpp"
#include "live/live_stage.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Samples of paths per pixel of a draft.
inline constexpr int kDraftSamples = 8;

struct LivePictures {
  Vec2i view_size{0, 0};
  Image8 views;                 ///< sRGB codes; a quilt of facts.tiles of view_size
  std::optional<Image8> panel;  ///< what the panel shows; none: it is not known yet
};

/// Few pixels, one sample each or a few paths. None of the test pattern, which has no scene.
std::optional<LivePictures> coarse_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// With fewer samples than the render has; none where it would take as long.
std::optional<LivePictures> draft_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context);

/// The codes that a render's 8-bit pictures hold. Throws Error for parameters that contradict each other.
std::optional<LivePictures> finished_pictures(LiveStage& live, const PageFacts& facts, int frame);

/// The disparity codes (view/disparity_codes.hpp) of views of that size, in a quilt. Needs facts.has_depth.
Image8 depth_picture(LiveStage& live, const PageFacts& facts, Vec2i view_size, int frame);

}  // namespace lippmann

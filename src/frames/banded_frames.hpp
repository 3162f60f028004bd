// Renders frames in bands of rows, into one film in memory. Tracing then needs working memory for one band only.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"
#include "frames/strip_maker.hpp"

namespace lippmann {

/// `film` is the size of a whole frame. `wanted` selects the layers of a frame. `context` must outlive the result.
std::unique_ptr<FrameMaker> make_banded_frames(StripMaker bands, Vec2i film, const FrameAovs& wanted, const Context& context);

}  // namespace lippmann

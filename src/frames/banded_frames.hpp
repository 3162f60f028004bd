// Renders frames band by band into one film in memory. Tracing needs working memory for one band of rows only.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"
#include "frames/strip_maker.hpp"

namespace lippmann {

/// Returns a maker whose frames have the same bits as frames rendered in the same number of strips. `film` is the size of a
/// whole frame, `wanted` its layers. `context` must outlive the maker.
std::unique_ptr<FrameMaker> make_banded_frames(StripMaker bands, Vec2i film, const FrameAovs& wanted, const Context& context);

}  // namespace lippmann

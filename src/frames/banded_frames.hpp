// Frames rendered band by band into one film in memory: the working memory of tracing is that of one band of rows.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"
#include "frames/strip_maker.hpp"

namespace lippmann {

/// The bits of frames that are rendered in as many strips. film: the size of a whole frame. wanted: its layers. `context` must
/// outlive the maker.
std::unique_ptr<FrameMaker> make_banded_frames(StripMaker bands, Vec2i film, const FrameAovs& wanted, const Context& context);

}  // namespace lippmann

// Traces key frames completely. In other frames, traces only the blocks that may differ from the key frame, and copies all
// other blocks. The bits are the same as if every frame were traced, whichever frames are key frames.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

std::unique_ptr<FrameMaker> make_exact_frames(const MakerParts& parts, const CopySettled& reuse);

/// Memory that the maker keeps between frames.
inline constexpr double kExactFramesBytesPerPixel = 3 * sizeof(float);

}  // namespace lippmann

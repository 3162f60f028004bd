// Traces key frames completely. In other frames, traces only the blocks that may differ from the key frame, and copies all
// others. The bits are the same as if every frame were traced.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

std::unique_ptr<FrameMaker> make_exact_frames(const MakerParts& parts, const CopySettled& reuse);

inline constexpr double kExactFramesBytesPerPixel = 3 * sizeof(float);

}  // namespace lippmann

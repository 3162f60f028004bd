// Frames by exact reuse: key frames traced whole, of the others only the blocks that do not provably stay as they are in the
// key. The same bits as if every frame were traced, whichever frames are keys.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

std::unique_ptr<FrameMaker> make_exact_frames(const MakerParts& parts, const CopySettled& reuse);

/// Bytes per pixel that the maker keeps between frames.
inline constexpr double kExactFramesBytesPerPixel = 3 * sizeof(float);

}  // namespace lippmann

// The paper's interpolated animation: key frames are traced, the frames between them made from their points; straight from the
// two keys, or by halving (reuse/frame_plan.hpp). Of the frames that others are made from, only those on the way to the frame
// under way are kept.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

std::unique_ptr<FrameMaker> make_forward_frames(const MakerParts& parts, const Interpolate& reuse);

/// Bytes per pixel that the maker keeps between frames.
double forward_frames_bytes_per_pixel(const Interpolate& reuse);

}  // namespace lippmann

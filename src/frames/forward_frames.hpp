// Makes interpolated frames, based on Eljdid, Aggoun and Youssef (README.md). Key frames are traced. The frames between them
// are made from the points of key frames, directly or by halving (reuse/frame_plan.hpp).
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

std::unique_ptr<FrameMaker> make_forward_frames(const MakerParts& parts, const Interpolate& reuse);

double forward_frames_bytes_per_pixel(const Interpolate& reuse);

}  // namespace lippmann

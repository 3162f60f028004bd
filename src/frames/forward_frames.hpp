// Makes interpolated frames, based on Eljdid, Aggoun and Youssef (README.md). Key frames are traced. A frame between two key
// frames is made from the points of both, or, with halving, from two nearer frames that were made before
// (reuse/frame_plan.hpp).
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

std::unique_ptr<FrameMaker> make_forward_frames(const MakerParts& parts, const Interpolate& reuse);

double forward_frames_bytes_per_pixel(const Interpolate& reuse);

}  // namespace lippmann

// Interpolated frames with a minimum PSNR (--reuse interpolate --min-psnr). Key frames are traced; the others are predicted
// from them and traced where they are uncertain (reuse/quality_floor.hpp).
//
// Counts (reuse/tracing_costs.hpp), never a clock, decide whether prediction pays off. The animation is divided into segments
// of kSegmentIntervals intervals, each of kDefaultKeyframes frames or the requested number. In the first interval of a segment,
// the middle frame is predicted, traced completely and compared: its errors calibrate the uncertainty in the segment and the
// cost of the other frames. If prediction pays off, the whole segment uses such intervals; if not, intervals of half the length
// are tried, unless a length was requested. If nothing pays off, all frames of the segment are traced at no further cost. In
// each interval the middle frame is made first; if it has to be traced completely, so are the others.
//
// The trials and their results depend on the whole animation only, so a part of an animation that is rendered alone has the
// same bytes as in the whole.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

/// `reuse.min_psnr_db` must be set.
std::unique_ptr<FrameMaker> make_error_bounded_frames(const MakerParts& parts, const Interpolate& reuse);

/// Returns the memory that the maker keeps between frames, in bytes per pixel.
double error_bounded_frames_bytes_per_pixel();

/// Returns the number of frames of a segment.
int error_bounded_frames_per_segment(const Interpolate& reuse);

}  // namespace lippmann

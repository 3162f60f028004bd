// Makes interpolated frames with a minimum PSNR (--reuse interpolate --min-psnr). Key frames are traced. All other frames are
// predicted from key frames, and traced where the prediction is uncertain (reuse/quality_floor.hpp).
//
// Estimated costs decide whether prediction pays off (reuse/tracing_costs.hpp).
//   1. The animation is divided into segments of kSegmentIntervals intervals. An interval has kDefaultKeyframes frames, or the
//      requested number.
//   2. In the first interval of a segment, the middle frame is both predicted and completely traced. The errors of the
//      prediction calibrate the estimated uncertainty of pixels, from which the expected cost of the other frames follows.
//   3. If prediction pays off, the whole segment uses intervals of this length.
//   4. If not, step 2 is repeated with half the interval length, unless a length was requested.
//   5. If no length pays off, all frames of the segment are traced. No further trials are made.
//   6. In each interval the middle frame is made first. If it has to be traced completely, the other frames of the interval are
//      traced as well.
//
// Trials depend only on the whole animation, so a part that is rendered alone has the same bytes.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

/// `reuse.min_psnr_db` must be set.
std::unique_ptr<FrameMaker> make_error_bounded_frames(const MakerParts& parts, const Interpolate& reuse);

double error_bounded_frames_bytes_per_pixel();

int error_bounded_frames_per_segment(const Interpolate& reuse);

}  // namespace lippmann

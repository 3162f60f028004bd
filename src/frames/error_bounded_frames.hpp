// Interpolated frames that keep to a PSNR (--reuse interpolate --min-psnr): key frames are traced, the others predicted from
// them and traced where they are uncertain (reuse/quality_floor.hpp).
//
// Whether that pays is told from counts (reuse/tracing_costs.hpp), never from a clock. An animation is cut into segments of
// kSegmentIntervals intervals, each of kDefaultKeyframes frames or as many as were asked for. In the first interval of a
// segment the middle frame is predicted, traced as a whole and compared: its errors tell what uncertainty means in the segment,
// and what the other frames will cost. If that pays, all of the segment has such intervals; if not, intervals half as long are
// tried, unless a length was asked for. If nothing pays, all frames of the segment are traced, at no further cost. In every
// interval the middle frame is made first; where it has to be traced as a whole after all, so have the others.
//
// What is tried first depends on the animation alone, and what comes of it as well, so that any part of an animation has the
// same bytes as in the whole.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

/// `reuse.min_psnr_db` must be set.
std::unique_ptr<FrameMaker> make_error_bounded_frames(const MakerParts& parts, const Interpolate& reuse);

/// Bytes per pixel that the maker keeps between frames.
double error_bounded_frames_bytes_per_pixel();

/// Frames for which it is found out together whether predicting pays.
int error_bounded_frames_per_segment(const Interpolate& reuse);

}  // namespace lippmann

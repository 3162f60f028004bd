// Frames from which other frames are made.
#pragma once

#include "frames/frame_maker.hpp"
#include "reuse/in_between.hpp"

namespace lippmann {

struct ForwardSource {
  PointImage image;
  FrameReport report;
};

ForwardParams forward_params(const Sampling& sampling, const Interpolate& reuse);

inline int key_frame_interval(const Interpolate& reuse) { return reuse.keyframes.value_or(kDefaultKeyframes); }

/// Traces a key frame with its points and prepares it for `maker`. Incomplete if the context is cancelled.
ForwardSource trace_source(const MakerParts& parts, const Interpolate& reuse, int frame, const InBetweenMaker& maker);

/// Returns the report of a frame that was made from other frames. Its times are not set.
FrameReport in_between_report(int frame, const InBetweenCounts& counts, const RayCounts& rays, Vec2i film);

}  // namespace lippmann

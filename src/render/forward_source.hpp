// A frame that others are made from.
#pragma once

#include "render/frame.hpp"
#include "reuse/in_between.hpp"

namespace lippmann {

struct ForwardSource {
  PointImage image;
  FrameReport report;
};

/// Traces a key frame, with its points, and prepares it for `maker`. Unfinished when context.cancelled is set meanwhile.
ForwardSource trace_source(Stage& stage, const FrameParams& params, int frame, const InBetweenMaker& maker,
                           const ThreadPool& pool, const Context& context);

/// Of a frame made from others; without times.
FrameReport in_between_report(int frame, const InBetweenCounts& counts, const RayCounts& rays, const Panel& panel);

}  // namespace lippmann

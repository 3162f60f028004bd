// Traces selected packets of a frame, while other packets are copied or interpolated from other frames.
#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces the packets with a nonzero entry in `wanted`. A packet holds 16 consecutive pixels of a strip's order
/// (strip_order.hpp). Packets are counted strip by strip from the top, including the empty packets of a last strip with fewer
/// rows.
/// `film` must have the size of the panel. Other packets keep their content. Mirrored rays may share packets with other rays
/// than in trace_frame(), which changes rounding. Otherwise the result equals that of trace_frame(). It does not depend on the
/// number of threads. After cancellation, returns early with some packets unfinished.
RayCounts trace_packets(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                        const Workers& workers, Image& film);

}  // namespace lippmann

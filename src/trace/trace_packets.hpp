// Traces selected packets of a frame, while other packets are copied or interpolated from other frames.
#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces the packets with a nonzero entry in `wanted` into `film`, which must have the size of the panel. The pixels of other
/// packets do not change. A packet holds 16 pixels that are consecutive in the order of strip_order.hpp. Packets are numbered
/// strip by strip from the top; a last strip with fewer rows has as many numbers as the others.
///
/// The result does not depend on the number of threads. It equals that of trace_frame(), except for rounding, because mirrored
/// rays may share packets with other rays. After cancellation, returns early with some packets unfinished.
RayCounts trace_packets(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                        const Workers& workers, Image& film);

}  // namespace lippmann

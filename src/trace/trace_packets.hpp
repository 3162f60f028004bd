// Traces selected packets of a frame when the others are reused from other frames.
#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces the packets with a nonzero entry in `wanted`. Packets are 16 neighbours in a strip's order (strip_order.hpp), strip
/// by strip from the top; `wanted` also has entries for the empty packets of a lower last strip. The rays equal those of
/// trace_frame(), except for rounding where mirrored rays share packets with different rays. `film` must have the panel's size;
/// other packets stay unchanged. The result does not depend on the number of threads. After cancellation it returns early with
/// some packets unfinished.
RayCounts trace_packets(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                        const Workers& workers, Image& film);

}  // namespace lippmann

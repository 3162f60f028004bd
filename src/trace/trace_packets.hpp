#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces the packets with a nonzero entry in `wanted` into `film`, which must have the size of the panel. Other pixels keep
/// their content. A packet is 16 consecutive pixels in the order of strip_order.hpp. All strips have the same number of
/// packets.
///
/// The result equals that of trace_frame(), except for rounding, because mirrored rays may share packets with other rays. After
/// cancellation, returns early.
RayCounts trace_packets(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                        const Workers& workers, Image& film);

}  // namespace lippmann

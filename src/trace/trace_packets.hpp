// Traces chosen packets of a frame: what is left when the others are reused from other frames.
#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Packets are 16 neighbours in a strip's order (strip_order.hpp), strip by strip from the top. Traces those for which `wanted`
/// (by packet of the frame; those of a lower last strip that have no pixels count too) is not 0, as trace_frame would: the same
/// rays, but for how crossings round where other rays share their mirror packets. `film` has the panel's size, and what lies in
/// other packets stays as it is. The same bits for any number of threads. Returns early, some packets unfinished, when
/// context.cancelled is set.
RayCounts trace_packets(const Shot& shot, const TraceParams& params, std::span<const std::uint8_t> wanted,
                        const Workers& workers, Image& film);

}  // namespace lippmann

// Callbacks that trace single pixels or packets of an in-between frame.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lippmann/image/image.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// Traces the given pixels (ascending) of the current frame into its film and, if not null, its points.
using TracePixels = std::function<void(std::span<const std::uint32_t> pixels, Image& film, PrimaryPoints* points)>;

/// Traces the packets of the current frame with a nonzero entry in `wanted` (trace/trace_packets.hpp) into its film.
using TracePackets = std::function<void(std::span<const std::uint8_t> wanted, Image& film)>;

}  // namespace lippmann

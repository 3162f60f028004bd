// Callbacks that trace single pixels or packets of an in-between frame.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lippmann/image/image.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// Traces the pixels with the given ascending indices. Writes colours to `film`, and hit points to `points` if it is not null.
using TracePixels = std::function<void(std::span<const std::uint32_t> pixels, Image& film, PrimaryPoints* points)>;

/// Traces the packets of 16 pixels (trace/trace_packets.hpp) whose entry in `wanted` is not 0. Writes colours to `film`.
using TracePackets = std::function<void(std::span<const std::uint8_t> wanted, Image& film)>;

}  // namespace lippmann

// How the frames in between have single pixels, or packets of them, traced.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lippmann/image/image.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// Traces the given pixels (ascending) of the frame under way into its film and, where not null, its points.
using TracePixels = std::function<void(std::span<const std::uint32_t> pixels, Image& film, PrimaryPoints* points)>;

/// Traces those packets of the frame under way into its film for which `wanted` (trace/trace_packets.hpp) is not 0.
using TracePackets = std::function<void(std::span<const std::uint8_t> wanted, Image& film)>;

}  // namespace lippmann

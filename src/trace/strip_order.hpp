// The order in which the pixels of a strip are traced. 16 consecutive pixels form a packet.
//
// A strip is a horizontal band of the panel, and the unit of work of a thread. Packets along a lens or within one view have
// coherent rays, while packets along a row would diverge.
#pragma once

#include <cstdint>
#include <vector>

#include "device/lanes.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

/// Number of packets of a block. All packets of a block are shaded before their mirror rays are traced. A block yields enough
/// mirror rays to fill packets, and fits into the cache.
inline constexpr int kPacketsPerBlock = 16;

struct StripPixel {
  std::uint16_t x, y;  ///< y = 0 is the strip's top row
};

struct StripOrder {
  int strip_height = 16;  ///< rows of a full strip; the last strip may have fewer
  /// Each pixel of a full strip once, in tracing order. If the last strip has fewer rows, skip the pixels of missing rows.
  std::vector<StripPixel> pixels;
};

int rows_per_strip(const Optics& optics);

StripOrder make_strip_order(const Optics& optics, RayOrder order);

}  // namespace lippmann

// The order in which the pixels of a strip are traced. 16 consecutive pixels form a packet.
//
// A strip is a horizontal band of the panel, and the unit of work of a thread. Its height depends only on the optics. A packet
// along a row mixes all directions below a lens, so its rays diverge. The rays of a packet along a lens or within one
// directional view stay coherent.
#pragma once

#include <cstdint>
#include <vector>

#include "device/lanes.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

/// Number of packets of a block. All packets of a block are shaded before their mirror rays are traced. A block is large enough
/// to fill the packets of the next wave. It is small enough to stay in cache and to cover a small area (touched_blocks.hpp).
inline constexpr int kPacketsPerBlock = 16;

struct StripPixel {
  std::uint16_t x, y;  ///< y = 0 is the strip's top row
};

struct StripOrder {
  int strip_height = 16;  ///< rows of a full strip; the last strip may have fewer
  /// Lists each pixel of a full strip once, in tracing order. In a last strip with fewer rows, the pixels of missing rows are
  /// skipped.
  std::vector<StripPixel> pixels;
};

int rows_per_strip(const Optics& optics);

StripOrder make_strip_order(const Optics& optics, RayOrder order);

}  // namespace lippmann

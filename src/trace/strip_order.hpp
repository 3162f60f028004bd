// The order in which a strip's pixels are traced ("pixel-tracing style" in the paper). 16 consecutive pixels form a packet.
//
// A strip is a horizontal band of the panel and the unit of work of a thread. Its height depends on the optics only. Packets
// along a row mix the directions below a lens and diverge; packets down a lens, or within one directional view, stay coherent.
#pragma once

#include <cstdint>
#include <vector>

#include "device/lanes.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

/// Packets of a block. A block's packets are shaded before their mirror rays are traced. The number is large enough to fill the
/// packets of the next wave, and small enough to stay in cache and to cover a small area (touched_blocks.hpp).
inline constexpr int kPacketsPerBlock = 16;

struct StripPixel {
  std::uint16_t x, y;  ///< y counts from the strip's top
};

struct StripOrder {
  int strip_height = 16;           ///< rows; the last strip may be lower
  std::vector<StripPixel> pixels;  ///< each pixel of a full strip once; a lower last strip skips pixels below its height
};

/// Returns the number of rows of a full strip.
int rows_per_strip(const Optics& optics);

StripOrder make_strip_order(const Optics& optics, RayOrder order);

}  // namespace lippmann

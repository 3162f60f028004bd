// The order in which a strip's pixels are traced ("pixel-tracing style" in the paper): 16 neighbours in this order form a
// packet.
//
// A strip is a horizontal band of the panel; strips are the unit of work of a thread, of a height that depends on the optics
// alone. Packets of rows mix the directions below a lens and diverge; packets down a lens, or within one directional view, stay
// coherent.
#pragma once

#include <cstdint>
#include <vector>

#include "device/lanes.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

/// Packets of a block: they are shaded before their mirror rays are traced, all of them together. Enough to fill the next
/// wave's packets; few enough to stay in cache and to be near one another in the picture (touched_blocks.hpp).
inline constexpr int kPacketsPerBlock = 16;

struct StripPixel {
  std::uint16_t x, y;  ///< y from the strip's top
};

struct StripOrder {
  int strip_height = 16;  ///< rows; the last strip may be lower
  std::vector<StripPixel>
      pixels;  ///< every pixel of a full strip once; a lower last strip skips those with y beyond its height
};

/// Rows of a full strip.
int rows_per_strip(const Optics& optics);

StripOrder make_strip_order(const Optics& optics, RayOrder order);

}  // namespace lippmann

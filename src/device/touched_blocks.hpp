// Which blocks of a frame have to do with certain boxes: those of which a ray, of any kind, meets one of them.
//
// A block is what is traced together: neighbouring packets, and the mirror and refracted rays that follow from them. Traced
// again, alone or with others, it gives the same bits. (Single pixels do not quite: which rays share a packet decides how a
// crossing rounds.) Boxes around whatever will move, in the frames to come, tell which blocks will stay exactly as they are:
// those whose rays all stay clear of the boxes see, and are lit by, nothing else than now. After the voxels of D. A. Jevans,
// "Object space temporal coherence for ray tracing", Graphics Interface 1992.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct HorizonBox {
  Bounds3f bounds;           ///< world space; without end: infinite
  std::uint8_t horizon = 0;  ///< a small number of the caller's
};

struct TouchedBlocks {
  static constexpr std::uint8_t kNever = 255;

  std::vector<HorizonBox> boxes;             ///< given
  std::vector<std::uint8_t> lowest_horizon;  ///< filled, by block: of the boxes met; kNever: none
  std::vector<std::uint32_t> rays;           ///< filled, by block: how many were traced
};

}  // namespace lippmann

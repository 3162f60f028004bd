// Finds the blocks of a frame whose rays, of any kind, hit given boxes.
//
// A block is the unit of tracing: neighbouring packets, and the mirror and refracted rays that follow from them. Retracing a
// block, alone or with others, gives the same bits. (Retracing single pixels does not, because the rays that share a packet
// affect rounding.) With boxes around everything that moves in the following frames, the blocks without hits provably stay
// unchanged: their rays meet only static objects and their light. Based on the voxels of D. A. Jevans, "Object space temporal
// coherence for ray tracing", Graphics Interface 1992.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct HorizonBox {
  Bounds3f bounds;           ///< world space; may be infinite
  std::uint8_t horizon = 0;  ///< a small number defined by the caller
};

struct TouchedBlocks {
  static constexpr std::uint8_t kNever = 255;

  std::vector<HorizonBox> boxes;             ///< input
  std::vector<std::uint8_t> lowest_horizon;  ///< output, by block: lowest horizon of the boxes hit; kNever: none
  std::vector<std::uint32_t> rays;           ///< output, by block: number of rays traced
};

}  // namespace lippmann

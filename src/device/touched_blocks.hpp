// Finds the blocks of a frame whose rays hit given boxes. Rays of all kinds count.
//
// A block consists of neighbouring packets of camera rays, and of the mirrored and refracted rays that follow from them.
// Retracing a block gives the same bits as tracing the whole frame. Retracing single pixels does not, because the rays that
// share a packet affect rounding.
//
// If boxes enclose everything that moves in the following frames, the blocks without hits provably stay unchanged. Based on the
// voxels of D. A. Jevans, "Object space temporal coherence for ray tracing", Graphics Interface 1992.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct HorizonBox {
  Bounds3f bounds;
  std::uint8_t horizon = 0;  ///< number that the caller assigns to the box, < 255
};

struct TouchedBlocks {
  static constexpr std::uint8_t kNever = 255;

  std::vector<HorizonBox> boxes;
  /// Output: for each block, the lowest horizon of the boxes that its rays hit; kNever: no box hit.
  std::vector<std::uint8_t> lowest_horizon;
  std::vector<std::uint32_t> rays;
};

}  // namespace lippmann

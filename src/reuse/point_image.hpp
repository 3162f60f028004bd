// The point image of a frame: behind every pixel the point that it shows, and in which colour. What other frames are made from.
//
// After the paper's point image. A pixel without a point ("missed", the paper's status -1) shows a colour that came from
// elsewhere, which is not passed on to other frames.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/scene/timeline.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// In PrimaryPoints::object: no point is known behind this pixel; its depth is not a number.
inline constexpr std::uint32_t kMissedObject = kNoObject - 1;
inline constexpr float kMissedDepth = std::numeric_limits<float>::quiet_NaN();

/// Where everything is at one time: the scene's nodes, and the display.
struct Moment {
  ResolvedScene resolved;
  Affine3f world_from_display;  ///< a similarity
};

/// Bits of PointImage::contrast: the colour differs from that of the next sample of its view to the right, to the left.
inline constexpr std::uint8_t kRightDiffers = 1, kLeftDiffers = 2;

struct PointImage {
  Moment moment;
  PrimaryPoints points;                  ///< at `moment`; kNoObject: background, kMissedObject: none
  Image film;                            ///< 3 channels, linear: the colour of every pixel
  std::vector<std::uint8_t> contrast;    ///< by pixel, of the bits above; empty: not looked for
  std::vector<std::uint8_t> provenance;  ///< by pixel, values of Provenance; empty: all were traced, or nobody asks
  std::vector<std::uint32_t> rays;       ///< by block that is traced together (TouchedBlocks::rays); empty: not counted
};

}  // namespace lippmann

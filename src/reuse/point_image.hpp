// The point image of a frame holds a point and a colour for each pixel. Other frames are made from it.
//
// Based on the paper's point image. A pixel without a point ("missed", the paper's status -1) has a colour, but the colour is
// not used for other frames.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/scene/timeline.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// Value of PrimaryPoints::object for pixels without a known point; the depth is NaN.
inline constexpr std::uint32_t kMissedObject = kNoObject - 1;
inline constexpr float kMissedDepth = std::numeric_limits<float>::quiet_NaN();

/// The state of scene nodes and display at one time.
struct Moment {
  ResolvedScene resolved;
  Affine3f world_from_display;  ///< a similarity
};

/// Bits of PointImage::contrast: the colour differs from that of the next sample of the view to the right or to the left.
inline constexpr std::uint8_t kRightDiffers = 1, kLeftDiffers = 2;

struct PointImage {
  Moment moment;
  PrimaryPoints points;                  ///< at `moment`; kNoObject: background, kMissedObject: unknown
  Image film;                            ///< 3 channels, linear
  std::vector<std::uint8_t> contrast;    ///< by pixel, the bits kRightDiffers and kLeftDiffers; empty: not computed
  std::vector<std::uint8_t> provenance;  ///< by pixel, values of Provenance; empty: all pixels were traced, or not recorded
  std::vector<std::uint32_t> rays;       ///< by block of rays traced together (TouchedBlocks::rays); empty: not counted
};

}  // namespace lippmann

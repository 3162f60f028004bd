// The point image of a frame holds the first hit point and the colour of each pixel. In-between frames are made from the point
// images of key frames. Based on Eljdid, Aggoun and Youssef (README.md). A pixel without a known point is "missed" (status -1
// in their paper). In-between frames do not use the colour of a missed pixel.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/scene/timeline.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// Value of PrimaryPoints::object for a missed pixel.
inline constexpr std::uint32_t kMissedObject = kNoObject - 1;
inline constexpr float kMissedDepth = std::numeric_limits<float>::quiet_NaN();

/// The poses of all scene nodes and of the display at one time.
struct Moment {
  ResolvedScene resolved;
  Affine3f world_from_display;  ///< rotation, translation and uniform scale
};

/// Bits of PointImage::contrast. kRightDiffers: the colour differs from that of the next sample to the right in the same view.
/// kLeftDiffers: the colour differs from that of the next sample to the left.
inline constexpr std::uint8_t kRightDiffers = 1, kLeftDiffers = 2;

struct PointImage {
  Moment moment;
  /// Points at `moment`. The object is kNoObject for background and kMissedObject for a missed pixel.
  PrimaryPoints points;
  Image film;  ///< 3 channels, linear
  /// One entry per pixel: the bits kRightDiffers and kLeftDiffers. Empty if not computed.
  std::vector<std::uint8_t> contrast;
  /// One value of Provenance per pixel. Empty if all pixels were traced, or if the provenance is not recorded.
  std::vector<std::uint8_t> provenance;
  /// Number of rays of each block of pixels (TouchedBlocks::rays). Empty if the rays are not counted.
  std::vector<std::uint32_t> rays;
};

}  // namespace lippmann

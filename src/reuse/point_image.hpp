// The point image of a frame holds the first hit point and the colour of each pixel. In-between frames are made from the point
// images of key frames. Based on Eljdid, Aggoun and Youssef (README.md). A pixel without a known point is "missed" (status -1
// in their paper).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/scene/timeline.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

inline constexpr std::uint32_t kMissedObject = kNoObject - 1;
inline constexpr float kMissedDepth = std::numeric_limits<float>::quiet_NaN();

struct Moment {
  ResolvedScene resolved;
  Affine3f world_from_display;
};

/// Bits of PointImage::contrast. The colour of a pixel differs from the colour of the next sample of the same view, to the
/// right (kRightDiffers) or to the left (kLeftDiffers).
inline constexpr std::uint8_t kRightDiffers = 1, kLeftDiffers = 2;

struct PointImage {
  Moment moment;
  PrimaryPoints points;
  Image film;  ///< 3 channels, linear
  /// One entry per pixel: kRightDiffers and kLeftDiffers. Empty if not computed.
  std::vector<std::uint8_t> contrast;
  /// One Provenance per pixel. Empty if all pixels were traced, or if not recorded.
  std::vector<std::uint8_t> provenance;
  /// Rays of each block of pixels (TouchedBlocks::rays). Empty if not counted.
  std::vector<std::uint32_t> rays;
};

}  // namespace lippmann

// Projects the points of a point image to another moment, and finds the visible point of each pixel.
//
// Based on the projection of point images with a z-buffer by Eljdid, Aggoun and Youssef (README.md). If several points land on
// a pixel, the one with the largest z in the display frame is visible; of equal depths, the one with the lowest source pixel.
// Background points keep their pixels, behind all other points, as if they were infinitely far away.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/reuse/projection_choices.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"

namespace lippmann {

inline constexpr std::uint32_t kNoSource = 0x7fffffffu;

/// The visible point of each pixel, encoded as a 64-bit key. The largest key wins.
/// - Bits 32 to 63: the depth. 0 means no point and 1 means background. Otherwise the bits encode z at the new moment; larger
///   values are nearer to the viewer.
/// - Bits 1 to 31: the inverted index of the source pixel.
/// - Bit 0: set if the colour changes from the source sample to its neighbour on the side of the target pixel's centre
///   (PointImage::contrast).
struct SplatBuffer {
  static constexpr std::uint32_t kBackgroundOrder = 1;

  std::vector<std::uint64_t> keys;

  static std::uint32_t source(std::uint64_t key) { return ~static_cast<std::uint32_t>(key) >> 1; }
  static bool color_changes(std::uint64_t key) { return (key & 1) != 0; }
  /// Returns z at the new moment, or -infinity for background.
  static float depth(std::uint64_t key) {
    const auto order = static_cast<std::uint32_t>(key >> 32);
    if (order == kBackgroundOrder) return -std::numeric_limits<float>::infinity();
    return std::bit_cast<float>(order & 0x80000000u ? order & 0x7fffffffu : ~order);
  }
};

struct SplatParams {
  SplatMode mode = SplatMode::kView;
  /// False gives wrong images, in which the highest source pixel is visible. For experiments only.
  bool z_buffer = true;
};

/// Thread-safe. One object suffices for a whole animation.
class Splatter {
 public:
  Splatter(const Optics& optics, const SplatParams& params);
  ~Splatter();
  Splatter(const Splatter&) = delete;
  Splatter& operator=(const Splatter&) = delete;

  /// Stores the visible points in `buffer`. `image` must have the size of the panel.
  void splat(const PointImage& image, const Motion& motion, const ThreadPool& pool, SplatBuffer& buffer) const;

  /// Returns the pixel on which one point lands, or nothing if it is not visible. Before the motion, the point is at depth z on
  /// the ray of `pixel`.
  std::optional<std::uint32_t> landing(std::uint32_t pixel, float z, std::uint32_t object, const Motion& motion) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

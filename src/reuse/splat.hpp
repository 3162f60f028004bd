// Projects the points of a point image to another moment, and finds the visible point of each pixel.
//
// Based on the paper's projection of point images with a z-buffer. Of all points that land on a pixel, the one nearest to the
// viewer wins (largest z in the display frame); among equals, the one with the lowest source pixel. The result thus does not
// depend on the order of processing or on threads. Background has no position: it stays in its pixel behind everything else, as
// if it were infinitely far away and the display did not turn.
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

/// The landed point of each pixel as one number; the largest wins. The upper half is the depth (0: nothing, 1: background,
/// otherwise z at the new moment, mapped so that larger is nearer to the viewer). The lower half is the inverted source pixel;
/// the lowest bit is set if the colour changes on the side of the sample on which the pixel's centre lies
/// (PointImage::contrast).
struct SplatBuffer {
  static constexpr std::uint32_t kBackgroundOrder = 1;

  std::vector<std::uint64_t> keys;  ///< one per pixel

  /// Returns the source pixel of the point, or kNoSource.
  static std::uint32_t source(std::uint64_t key) { return ~static_cast<std::uint32_t>(key) >> 1; }
  static bool color_changes(std::uint64_t key) { return (key & 1) != 0; }
  /// Returns z at the new moment; -inf for background.
  static float depth(std::uint64_t key) {
    const auto order = static_cast<std::uint32_t>(key >> 32);
    if (order == kBackgroundOrder) return -std::numeric_limits<float>::infinity();
    return std::bit_cast<float>(order & 0x80000000u ? order & 0x7fffffffu : ~order);
  }
};

struct SplatParams {
  SplatMode mode = SplatMode::kView;
  bool z_buffer = true;  ///< false: the highest source pixel wins, as if painted in order; gives wrong images, for experiments
};

/// Projects point images for an animation. Thread-safe; make one object per animation.
class Splatter {
 public:
  /// `optics` must pass validate().
  Splatter(const Optics& optics, const SplatParams& params);
  ~Splatter();
  Splatter(const Splatter&) = delete;
  Splatter& operator=(const Splatter&) = delete;

  /// Projects `image`, which must have the panel's size. `motion` moves its points to the new moment.
  void splat(const PointImage& image, const Motion& motion, const ThreadPool& pool, SplatBuffer& buffer) const;

  /// Returns the pixel on which a single point lands after `motion`. The point belongs to `object` and lies at depth z behind
  /// `pixel`. Returns nothing if it is not visible.
  std::optional<std::uint32_t> landing(std::uint32_t pixel, float z, std::uint32_t object, const Motion& motion) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

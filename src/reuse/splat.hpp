// Projects the points of a point image into another moment: which of them each pixel shows then.
//
// After the paper's projection of point images with a z-buffer. Of all points that land on a pixel the one nearest to the
// viewer wins (largest z in the display frame), of equals the one with the lowest source pixel; the outcome does not depend on
// the order of arrival, so neither on threads. Background has no place: it stays in its pixel, behind everything, as if it were
// infinitely far away and the display did not turn.
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

/// What has landed on each pixel, as one number whose maximum wins. Upper half: depth (0: nothing, 1: background, else z at the
/// new moment, so mapped that larger is nearer to the viewer). Lower half: the source pixel, inverted, and in the lowest bit
/// whether the colour changes beside it, on the side where the pixel's own place is (PointImage::contrast).
struct SplatBuffer {
  static constexpr std::uint32_t kBackgroundOrder = 1;

  std::vector<std::uint64_t> keys;  ///< one per pixel

  /// The pixel of the point image that is seen at a pixel; kNoSource: none.
  static std::uint32_t source(std::uint64_t key) { return ~static_cast<std::uint32_t>(key) >> 1; }
  static bool color_changes(std::uint64_t key) { return (key & 1) != 0; }
  /// z at the new moment; -inf of background.
  static float depth(std::uint64_t key) {
    const auto order = static_cast<std::uint32_t>(key >> 32);
    if (order == kBackgroundOrder) return -std::numeric_limits<float>::infinity();
    return std::bit_cast<float>(order & 0x80000000u ? order & 0x7fffffffu : ~order);
  }
};

struct SplatParams {
  SplatMode mode = SplatMode::kView;
  bool z_buffer = true;  ///< false: the highest source pixel wins, as if painted in order: wrong pictures, for study
};

/// Made once per animation. Thread-safe.
class Splatter {
 public:
  /// `optics` must pass validate().
  Splatter(const Optics& optics, const SplatParams& params);
  ~Splatter();
  Splatter(const Splatter&) = delete;
  Splatter& operator=(const Splatter&) = delete;

  /// `image` has the panel's size; `motion` takes its points to the new moment.
  void splat(const PointImage& image, const Motion& motion, const ThreadPool& pool, SplatBuffer& buffer) const;

  /// Where a single point lands: one of `object` at depth z behind `pixel`. None if it is not seen.
  std::optional<std::uint32_t> landing(std::uint32_t pixel, float z, std::uint32_t object, const Motion& motion) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

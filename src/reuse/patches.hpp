// Divides the panel into patches. A patch is the 16 pixels of a packet, which are neighbours in the ray order
// (trace/trace_packets.hpp).
//
// Scattered pixels cost two to three times as much per pixel as whole packets of coherent rays. For this reason a frame's
// predictions are kept or retraced by patch, not by pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

inline constexpr std::size_t kPatchPixels = 16;

class Patches {
 public:
  /// `optics` must pass validate().
  Patches(const Optics& optics, RayOrder order);

  std::size_t count() const { return begin_.size() - 1; }
  /// Returns the number of pixels of all patches.
  std::size_t pixel_count() const { return pixels_.size(); }
  /// Returns the pixels of a patch: 16, or fewer, even none, at the panel's lower edge.
  std::span<const std::uint32_t> pixels(std::size_t patch) const {
    return {pixels_.data() + begin_[patch], begin_[patch + 1] - begin_[patch]};
  }
  /// Computes the root mean square of each patch's pixel values, rounded; 0 for empty patches.
  void root_mean_squares(std::span<const std::uint8_t> of_pixels, const ThreadPool& pool,
                         std::vector<std::uint8_t>& of_patches) const;

  /// Returns the estimated cost of tracing each patch, relative to the mean patch. The estimate uses the ray counts of blocks
  /// of patches in another frame (TouchedBlocks::rays).
  std::vector<float> costs(std::span<const std::uint32_t> rays_of_blocks) const;

 private:
  std::size_t per_strip_ = 0;          ///< number of patches per strip
  std::vector<std::uint32_t> pixels_;  ///< sorted by patch
  std::vector<std::size_t> begin_;     ///< offset of each patch in pixels_, and the end of the last patch
};

}  // namespace lippmann

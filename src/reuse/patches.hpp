// Divides the panel into patches. A patch holds the 16 pixels of a packet, which are neighbours in the ray order
// (trace/trace_packets.hpp).
//
// A frame's predictions are kept or retraced in whole patches. Scattered single pixels would cost two to three times as much
// per pixel, because their rays are not coherent.
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
  Patches(const Optics& optics, RayOrder order);

  std::size_t count() const { return begin_.size() - 1; }
  std::size_t pixel_count() const { return pixels_.size(); }
  /// Returns the pixel indices of a patch. There are 16 of them; at the panel's lower edge there may be fewer, or none.
  std::span<const std::uint32_t> pixels(std::size_t patch) const {
    return {pixels_.data() + begin_[patch], begin_[patch + 1] - begin_[patch]};
  }
  /// Computes the root mean square of the pixel values of each patch, rounded to an integer. Empty patches get 0.
  void root_mean_squares(std::span<const std::uint8_t> of_pixels, const ThreadPool& pool,
                         std::vector<std::uint8_t>& of_patches) const;

  /// Returns the estimated cost of tracing each patch. A cost of 1 is the mean over all patches. `rays_of_blocks` holds the ray
  /// counts of another frame (TouchedBlocks::rays).
  std::vector<float> costs(std::span<const std::uint32_t> rays_of_blocks) const;

 private:
  std::size_t per_strip_ = 0;
  std::vector<std::uint32_t> pixels_;  ///< pixel indices, sorted by patch
  /// Position in pixels_ where each patch begins. The last entry is the size of pixels_.
  std::vector<std::size_t> begin_;
};

}  // namespace lippmann

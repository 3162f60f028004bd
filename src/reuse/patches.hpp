// Divides the panel into patches of the 16 pixels that are traced together (trace/trace_packets.hpp).
//
// The pixels of a patch are either all predicted from other frames or all traced. Tracing single pixels would cost two to three
// times as much per pixel, because their rays are not coherent.
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
  /// Returns the indices of a patch's pixels: 16, or fewer at the panel's lower edge.
  std::span<const std::uint32_t> pixels(std::size_t patch) const {
    return {pixels_.data() + begin_[patch], begin_[patch + 1] - begin_[patch]};
  }
  /// Computes the root mean square of the pixel values in each patch, rounded to an integer. Empty patches get 0.
  void root_mean_squares(std::span<const std::uint8_t> of_pixels, const ThreadPool& pool,
                         std::vector<std::uint8_t>& of_patches) const;

  /// Returns the cost of tracing each patch, relative to the mean. `rays_of_blocks` holds ray counts of another frame
  /// (TouchedBlocks::rays).
  std::vector<float> costs(std::span<const std::uint32_t> rays_of_blocks) const;

 private:
  std::size_t per_strip_ = 0;
  std::vector<std::uint32_t> pixels_;
  std::vector<std::size_t> begin_;
};

}  // namespace lippmann

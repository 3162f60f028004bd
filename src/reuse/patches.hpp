// The panel in patches: the pixels that are traced as one packet, 16 neighbours in the ray order (trace/trace_packets.hpp).
//
// Scattered pixels cost two to three times as much per pixel to trace as whole packets, whose rays travel together. So it is
// patches that are trusted or traced, not pixels.
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
  /// How many pixels all patches have.
  std::size_t pixel_count() const { return pixels_.size(); }
  /// The pixels of one patch: 16, fewer or none at the panel's lower edge.
  std::span<const std::uint32_t> pixels(std::size_t patch) const {
    return {pixels_.data() + begin_[patch], begin_[patch + 1] - begin_[patch]};
  }
  /// The root mean square of every patch's pixels' values, rounded; 0 of none.
  void root_mean_squares(std::span<const std::uint8_t> of_pixels, const ThreadPool& pool,
                         std::vector<std::uint8_t>& of_patches) const;

  /// What each patch may cost to trace, in mean patches, by the rays that blocks of patches took in another frame
  /// (TouchedBlocks::rays).
  std::vector<float> costs(std::span<const std::uint32_t> rays_of_blocks) const;

 private:
  std::size_t per_strip_ = 0;          ///< patches
  std::vector<std::uint32_t> pixels_;  ///< patch by patch
  std::vector<std::size_t> begin_;     ///< where each patch begins in pixels_, and where the last ends
};

}  // namespace lippmann

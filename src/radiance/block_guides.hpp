// What samples say of the noise and of the first surfaces of a block's pixels, for NoisyFrame.
#pragma once

#include <array>

#include "radiance/block_estimates.hpp"
#include "trace/noisy_frame.hpp"
#include "trace/path_film.hpp"

namespace lippmann {

class BlockGuides {
 public:
  /// display_z: as FirstSurfaces has it.
  explicit BlockGuides(Vec4f display_z);
  BlockGuides(const BlockGuides&) = delete;
  BlockGuides& operator=(const BlockGuides&) = delete;

  /// Forgets the pixels before.
  void begin() { sums_ = {}, noise_.fill(0.0f); }

  /// Where samples under way tell of their surfaces, and of the light that is free of noise, by slot.
  const FirstSurfaces& surfaces_of_slots() const { return surfaces_; }
  float* seen_of_slots() { return slots_.seen.data(); }

  /// A finished sample of pixel e: its number, its light, and what has been told of it; the slot is then free again.
  void add(std::size_t e, std::uint32_t sample, std::size_t slot, Vec3f radiance);

  /// As means over the samples; every pixel has as many of either half.
  void write(const BlockEstimates& block, NoisyFrame& noisy) const;

 private:
  using Colors = std::array<float, 3 * BlockEstimates::kMost>;
  using Numbers = std::array<float, BlockEstimates::kMost>;
  struct Guides {
    Colors seen{}, albedo{}, normal{};
    Numbers z{}, met{};
  };

  Guides slots_, sums_;
  FirstSurfaces surfaces_;  ///< points into slots_
  Colors noise_{};
};

}  // namespace lippmann

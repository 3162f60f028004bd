// Absorption inside closed glass shapes.
//
// Based on: Khronos Group, KHR_materials_volume (Beer's law; the coefficient follows from the colour that remains after a given
// distance).
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// kSameMedium: the ray stays in its current medium.
inline constexpr std::uint16_t kNoMedium = 0, kSameMedium = 0xffff;

class Media {
 public:
  Media() = default;
  /// Assigns a number to each material with a solid volume. Throws Error if 16 bits do not suffice.
  explicit Media(const Scene& scene);

  /// Returns the number of the medium inside a material, or kNoMedium.
  std::uint16_t of_material(std::uint32_t material) const { return of_material_.empty() ? kNoMedium : of_material_[material]; }

  /// Returns the transmittance over `distance` in a medium. An infinite distance means that the shape is not closed, and gives
  /// 1.
  Vec3f transmittance(std::uint16_t medium, float distance) const {
    if (!(distance < kInfinity)) return Vec3f(1.0f);
    return glm::exp(-distance * absorption_[medium]);
  }

 private:
  std::vector<Vec3f> absorption_;
  std::vector<std::uint16_t> of_material_;  ///< number of the medium inside each material; empty if the scene has no media
};

}  // namespace lippmann

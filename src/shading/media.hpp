// Absorption inside closed glass shapes.
//
// Based on: Khronos Group, KHR_materials_volume (Beer's law, defined by a colour after a distance).
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Media are identified by 16-bit numbers, to keep rays small.
inline constexpr std::uint16_t kNoMedium = 0, kSameMedium = 0xffff;

class Media {
 public:
  Media() = default;
  /// Numbers all materials with a solid volume. Throws Error if there are more such materials than numbers.
  explicit Media(const Scene& scene);

  /// Returns the medium inside a material, or kNoMedium.
  std::uint16_t of_material(std::uint32_t material) const { return of_material_.empty() ? kNoMedium : of_material_[material]; }

  /// Returns the transmittance over `distance` in a medium. Returns 1 for an infinite distance: the ray never left the medium,
  /// so the shape is not closed.
  Vec3f transmittance(std::uint16_t medium, float distance) const {
    if (!(distance < kInfinity)) return Vec3f(1.0f);
    return glm::exp(-distance * absorption_[medium]);
  }

 private:
  std::vector<Vec3f> absorption_;           ///< absorption coefficient by medium, per world unit
  std::vector<std::uint16_t> of_material_;  ///< empty without media
};

}  // namespace lippmann

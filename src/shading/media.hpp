// What fills closed shapes of glass: how much light is left after a way through it.
//
// Based on: Khronos Group, KHR_materials_volume (Beer's law, by a colour that is left after a distance).
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Media are named by small numbers, so that a ray that carries one is no larger.
inline constexpr std::uint16_t kNoMedium = 0, kSameMedium = 0xffff;

class Media {
 public:
  Media() = default;
  /// Numbers all materials that fill what they bound. Throws Error where there are more of them than numbers.
  explicit Media(const Scene& scene);

  /// kNoMedium for a material that fills nothing.
  std::uint16_t of_material(std::uint32_t material) const { return of_material_.empty() ? kNoMedium : of_material_[material]; }

  /// The share of light that is left after `distance` in a medium. A ray that never comes out of it has met no closed shape:
  /// an infinite distance leaves all.
  Vec3f transmittance(std::uint16_t medium, float distance) const {
    if (!(distance < kInfinity)) return Vec3f(1.0f);
    return glm::exp(-distance * absorption_[medium]);
  }

 private:
  std::vector<Vec3f> absorption_;           ///< by medium, per world unit
  std::vector<std::uint16_t> of_material_;  ///< empty: there are no media
};

}  // namespace lippmann

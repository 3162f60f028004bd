// Sheen: light scattered by fibres on a surface.
//
// Based on: A. Estevez, C. Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017 course (the Charlie distribution
// and its fitted shadowing); Khronos Group, KHR_materials_sheen (alpha = roughness^2; the albedo scales the layers below).
//
// We deviate:
// 1. Shadowing is not softened towards the terminator, so that the lobe stays reciprocal.
// 2. The albedo is clamped to 1, which the fit exceeds at grazing angles.
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns the BRDF divided by the sheen colour, without the cosine. z points along the surface normal, and both directions
/// must have z > 0.
float sheen_f(Vec3f view, Vec3f light, float roughness);

class SheenAlbedo {
 public:
  SheenAlbedo();
  ~SheenAlbedo();
  SheenAlbedo(const SheenAlbedo&) = delete;
  SheenAlbedo& operator=(const SheenAlbedo&) = delete;

  /// Returns the directional albedo of white sheen. `cosine` is the cosine between view and normal, in [0, 1]. Thread-safe. The
  /// first call computes the table, which takes about 0.1 s.
  float operator()(float cosine, float roughness) const;

 private:
  static constexpr int kSize = 32;
  using Table = std::array<std::array<float, kSize>, kSize>;
  static Table integrated();

  mutable std::once_flag once_;
  mutable std::unique_ptr<const Table> table_;
};

}  // namespace lippmann

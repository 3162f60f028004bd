// Sheen: light scattered by fibres on a surface, and a table of its albedo over angle and roughness.
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

/// Returns the BRDF divided by the sheen colour, without the cosine. Both directions are local, with z along the normal, and
/// must have z > 0. `roughness` is in [0, 1].
float sheen_f(Vec3f view, Vec3f light, float roughness);

class SheenAlbedo {
 public:
  SheenAlbedo();
  ~SheenAlbedo();
  SheenAlbedo(const SheenAlbedo&) = delete;
  SheenAlbedo& operator=(const SheenAlbedo&) = delete;

  /// Returns the directional albedo of white sheen, in [0, 1]. `cosine` is the cosine between view and normal, in [0, 1].
  /// Thread-safe. The first call computes the table (about 0.1 s), so that scenes without sheen do not pay for it.
  float operator()(float cosine, float roughness) const;

 private:
  static constexpr int kSize = 32;                            ///< entries per dimension
  using Table = std::array<std::array<float, kSize>, kSize>;  ///< indexed by [roughness][cosine]
  static Table integrated();

  mutable std::once_flag once_;
  mutable std::unique_ptr<const Table> table_;
};

}  // namespace lippmann

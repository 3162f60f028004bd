// Light that fibres on a surface scatter, and how much of it there is in all: a table over angle and roughness.
//
// Based on: A. Estevez, C. Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017 course (the Charlie distribution,
// its shadowing as fitted there); Khronos Group, KHR_materials_sheen (alpha = roughness^2; what lies below is scaled by the
// albedo).
// We deviate: shadowing is not softened towards the terminator, so that the lobe is reciprocal; and a table that exceeds 1, as
// the fit does at grazing angles, ends there.
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Per colour of the sheen, without the cosine. Local directions: z is the normal; both z > 0. roughness in [0, 1].
float sheen_f(Vec3f view, Vec3f light, float roughness);

class SheenAlbedo {
 public:
  SheenAlbedo();
  ~SheenAlbedo();
  SheenAlbedo(const SheenAlbedo&) = delete;
  SheenAlbedo& operator=(const SheenAlbedo&) = delete;

  /// Directional albedo of white sheen, in [0, 1]. cosine: between the view and the normal, in [0, 1]. The first call, from
  /// whichever thread, integrates the table: some 0.1 s, which scenes without sheen need not wait for.
  float operator()(float cosine, float roughness) const;

 private:
  static constexpr int kSize = 32;                            ///< entries along each side of the table
  using Table = std::array<std::array<float, kSize>, kSize>;  ///< [roughness][cosine]
  static Table integrated();

  mutable std::once_flag once_;
  mutable std::unique_ptr<const Table> table_;
};

}  // namespace lippmann

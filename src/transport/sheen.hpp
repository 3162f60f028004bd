// Sheen: light scattered by fibres on a surface, and a table of its albedo over angle and roughness.
//
// Based on: A. Estevez, C. Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017 course (the Charlie distribution
// and its fitted shadowing); Khronos Group, KHR_materials_sheen (alpha = roughness^2; the layers below are scaled by the
// albedo).
// This implementation deviates in two points: shadowing is not softened towards the terminator, so the lobe stays reciprocal;
// and the albedo is clamped to 1, which the fit exceeds at grazing angles.
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns the BRDF per sheen colour, without the cosine. In local directions z is the normal; both z must be > 0. roughness in
/// [0, 1].
float sheen_f(Vec3f view, Vec3f light, float roughness);

class SheenAlbedo {
 public:
  SheenAlbedo();
  ~SheenAlbedo();
  SheenAlbedo(const SheenAlbedo&) = delete;
  SheenAlbedo& operator=(const SheenAlbedo&) = delete;

  /// Returns the directional albedo of white sheen, in [0, 1]. cosine: between the view and the normal, in [0, 1]. The first
  /// call integrates the table (about 0.1 s), so scenes without sheen do not pay for it. Thread-safe.
  float operator()(float cosine, float roughness) const;

 private:
  static constexpr int kSize = 32;                            ///< entries along each side of the table
  using Table = std::array<std::array<float, kSize>, kSize>;  ///< [roughness][cosine]
  static Table integrated();

  mutable std::once_flag once_;
  mutable std::unique_ptr<const Table> table_;
};

}  // namespace lippmann

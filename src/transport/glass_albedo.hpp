// Directional albedo of single scattering at rough glass, for reflection and refraction together. The factor 1 / albedo
// compensates for light that hits more than one facet.
//
// Based on: E. Turquin, "Practical multiple scattering compensation for microfacet models", 2019 (a white surface is lossless
// if all its lobes are divided by their directional albedo).
#pragma once

#include <array>
#include <memory>
#include <mutex>

namespace lippmann {

class GlassAlbedo {
 public:
  GlassAlbedo();
  ~GlassAlbedo();
  GlassAlbedo(const GlassAlbedo&) = delete;
  GlassAlbedo& operator=(const GlassAlbedo&) = delete;

  /// Returns the albedo. `cosine` is the cosine between view and normal, in [0, 1]. eta = n_beyond / n_here is clamped to [1/3,
  /// 3]. The error is below 1 % for indices of refraction >= 1.3.
  ///
  /// Thread-safe. The first call computes the tables, which takes about 0.2 s.
  float single(float cosine, float alpha, float eta) const;

 private:
  struct Tables;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Tables> tables_;
};

}  // namespace lippmann

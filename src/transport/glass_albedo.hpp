// Directional albedo of single scattering at rough glass, reflection and refraction together. The rest of the light, 1 -
// albedo, hits more than one facet; the factor 1 / albedo compensates for it.
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

  /// Returns the albedo. cosine: between the view and the normal, in [0, 1]. eta = n_beyond / n_here, clamped to [1/3, 3]. The
  /// error is within 1 % for indices of refraction of 1.3 and more. The first call integrates the tables (about 0.2 s), so
  /// scenes without rough glass do not pay for it. Thread-safe.
  float single(float cosine, float alpha, float eta) const;

 private:
  struct Tables;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Tables> tables_;
};

}  // namespace lippmann

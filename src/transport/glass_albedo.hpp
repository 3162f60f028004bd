// How much light one scattering at rough glass sends on, reflected and refracted together: what is missing to 1 met more than
// one facet, and is made up for by the factor 1 / albedo.
//
// Based on: E. Turquin, "Practical multiple scattering compensation for microfacet models", 2019 (a white surface whose lobes
// are all divided by their directional albedo loses nothing).
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

  /// cosine: between the view and the normal, in [0, 1]; eta = n_beyond / n_here, as if 1/3 or 3 beyond these. Within 1 % for
  /// glass of 1.3 and more. The first call, from whichever thread, integrates the tables: some 0.2 s, which scenes without
  /// rough glass need not wait for.
  float single(float cosine, float alpha, float eta) const;

 private:
  struct Tables;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Tables> tables_;
};

}  // namespace lippmann

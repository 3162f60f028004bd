// The colours of thin films: light that is mirrored at both sides of a film as thin as its waves are long.
//
// Based on: L. Belcour, P. Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", ACM
// TOG 36(4), 2017; Khronos Group, KHR_materials_iridescence (Schlick's reflectance of the surface, sRGB's primaries). We
// deviate: what the film's own front mirrors is Fresnel's, else films that vanish would be seen at a slant.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

struct ThinFilm {
  float ior = 1.3f;  ///< >= 1
  float thickness_nm = 400.0f;
};

/// The share of red, green and blue light from air that film and surface mirror together, in [0, 1]. f0: the surface's
/// own reflectance at normal incidence, without the film; cosine: between the light and the normal.
Vec3f film_reflectance(const ThinFilm& film, Vec3f f0, float cosine);

}  // namespace lippmann

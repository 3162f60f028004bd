// Thin-film interference: reflection at both sides of a film about as thin as the wavelength.
//
// Based on: L. Belcour, P. Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", ACM TOG
// 36(4), 2017; Khronos Group, KHR_materials_iridescence (Schlick's reflectance of the surface, sRGB primaries). We deviate: the
// front of the film reflects by Fresnel's equations, because vanishing films would otherwise be visible at grazing angles.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

struct ThinFilm {
  float ior = 1.3f;
  float thickness_nm = 400.0f;
};

Vec3f film_reflectance(const ThinFilm& film, Vec3f f0, float cosine);

}  // namespace lippmann

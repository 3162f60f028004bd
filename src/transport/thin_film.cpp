// Notation follows Belcour and Barla (thin_film.hpp). Medium 1 is air, 2 the film and 3 the surface. R and T are reflectance
// and transmittance of a boundary, phi is the phase shift of a reflection, and D the optical path difference of the film.
//
// The reflected spectrum is a sum of cosines of the phase. The colour of each cosine follows from the Fourier transform of the
// eye's sensitivity, which is nearly a sum of Gaussians.
#include "transport/thin_film.hpp"

#include <algorithm>

#include "transport/microfacet.hpp"

namespace lippmann {
namespace {

/// One Gaussian term of a colour matching function over wave number. at() returns its Fourier transform.
struct Sensitivity {
  float height, place, variance;

  float at(float phase, float shift) const {
    return height * std::sqrt(2.0f * kPi * variance) * std::cos(place * phase + shift) * std::exp(-variance * phase * phase);
  }
};

// The values are from the table of the fit in section 4 of the paper in thin_film.hpp. X is the sum of two Gaussians.
constexpr Sensitivity kX{5.4856e-13f, 1.6810e+06f, 4.3278e+09f}, kXBlue{9.7470e-14f, 2.2399e+06f, 4.5282e+09f},
    kY{4.4201e-13f, 1.7953e+06f, 9.3046e+09f}, kZ{5.2481e-13f, 2.2084e+06f, 6.6121e+09f};
constexpr float kWhole = 1.0685e-7f;

/// Returns the linear sRGB colour of white light for a path difference of `path_m` metres and a phase shift per channel.
Vec3f color_of_path(float path_m, Vec3f shift) {
  const float phase = 2.0f * kPi * path_m;
  const float x = kX.at(phase, shift.x) + kXBlue.at(phase, shift.x), y = kY.at(phase, shift.y), z = kZ.at(phase, shift.z);
  return Vec3f(3.2404542f * x - 1.5371385f * y - 0.4985314f * z, -0.9692660f * x + 1.8760108f * y + 0.0415560f * z,
               0.0556434f * x - 0.2040259f * y + 1.0572252f * z) /
         kWhole;
}

float schlick(float f0, float cosine) { return f0 + (1.0f - f0) * schlick_weight(cosine); }

float reflectance_between(float from, float to) { return squared((to - from) / (to + from)); }

/// Returns the film's index of refraction, which fades to that of air below 30 nm, so that a vanishing film disappears
/// gradually.
float visible_ior(const ThinFilm& film) {
  const float t = std::clamp(film.thickness_nm / 30.0f, 0.0f, 1.0f);
  return 1.0f + (film.ior - 1.0f) * t * t * (3.0f - 2.0f * t);
}

}  // namespace

Vec3f film_reflectance(const ThinFilm& film, Vec3f f0, float cosine) {
  const float n2 = visible_ior(film), c1 = std::clamp(cosine, 0.0f, 1.0f);
  const float squared_c2 = 1.0f - (1.0f - c1 * c1) / (n2 * n2);
  if (squared_c2 < 0.0f) return Vec3f(1.0f);
  const float c2 = std::sqrt(squared_c2);
  // Schlick's approximation would reflect at grazing angles even if the film had the index of air.
  const float r12 = fresnel_dielectric(c1, n2), t121 = 1.0f - r12;

  Vec3f r23(0.0f), phi(0.0f);
  for (int c = 0; c < 3; ++c) {
    const float root = std::sqrt(std::clamp(f0[c], 0.0f, 0.9999f)), n3 = (1.0f + root) / (1.0f - root);
    r23[c] = schlick(reflectance_between(n2, n3), c2);
    phi[c] = kPi + (n3 < n2 ? kPi : 0.0f);  // each reflection at a less dense medium shifts the phase by pi
  }
  const Vec3f r123 = glm::clamp(r12 * r23, Vec3f(1e-5f), Vec3f(0.9999f)), root = glm::sqrt(r123);
  const Vec3f rs = t121 * t121 * r23 / (Vec3f(1.0f) - r123);
  const float path = 2.0f * n2 * c2 * film.thickness_nm * 1e-9f;

  Vec3f sum = r12 + rs, term = rs - Vec3f(t121);
  for (int m = 1; m <= 2; ++m) {
    term *= root;
    sum += 2.0f * term * color_of_path(static_cast<float>(m) * path, static_cast<float>(m) * phi);
  }
  return glm::clamp(sum, Vec3f(0.0f), Vec3f(1.0f));
}

}  // namespace lippmann

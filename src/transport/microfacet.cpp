#include "transport/microfacet.hpp"

namespace lippmann {

Vec3f Ggx::sample_visible(Vec3f v, Vec2f u) const { return AnisotropicGgx{Vec2f(alpha)}.sample_visible(v, u); }

Vec3f AnisotropicGgx::sample_visible(Vec3f v, Vec2f u) const {
  const Vec3f stretched = glm::normalize(Vec3f(alpha.x * v.x, alpha.y * v.y, v.z));
  // A uniform point of the spherical cap of mirror directions, then the half vector.
  const float angle = 2.0f * kPi * u.x;
  const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
  const float sine = std::sqrt(std::max(0.0f, 1.0f - z * z));
  const Vec3f h = Vec3f(sine * std::cos(angle), sine * std::sin(angle), z) + stretched;
  return glm::normalize(Vec3f(alpha.x * h.x, alpha.y * h.y, std::max(h.z, 1e-7f)));
}

float fresnel_dielectric(float cosine_incident, float eta) {
  const float ci = std::clamp(cosine_incident, 0.0f, 1.0f);
  const float sine2 = (1.0f - ci * ci) / squared(eta);
  if (sine2 >= 1.0f) return 1.0f;
  const float ct = std::sqrt(1.0f - sine2);
  const float parallel = (eta * ci - ct) / (eta * ci + ct), perpendicular = (ci - eta * ct) / (ci + eta * ct);
  return 0.5f * (squared(parallel) + squared(perpendicular));
}

}  // namespace lippmann

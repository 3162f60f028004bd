#include "transport/microfacet.hpp"

namespace lippmann {
namespace {

float squared(float x) { return x * x; }

/// Smith's Lambda for GGX.
float lambda(float alpha, Vec3f v) {
  const float cosine2 = v.z * v.z, tangent2 = std::max(0.0f, 1.0f - cosine2) / cosine2;
  return 0.5f * (std::sqrt(1.0f + alpha * alpha * tangent2) - 1.0f);
}

}  // namespace

float Ggx::distribution(Vec3f h) const {
  const float a2 = alpha * alpha;
  // sin^2 from x and y: 1 - cos^2 has no digits left where narrow lobes peak.
  const float d = a2 * h.z * h.z + h.x * h.x + h.y * h.y;
  return a2 / (kPi * d * d);
}

float Ggx::masking(Vec3f v) const { return 1.0f / (1.0f + lambda(alpha, v)); }

float Ggx::masking(Vec3f a, Vec3f b) const { return 1.0f / (1.0f + lambda(alpha, a) + lambda(alpha, b)); }

Vec3f Ggx::sample_visible(Vec3f v, Vec2f u) const {
  const Vec3f stretched = glm::normalize(Vec3f(alpha * v.x, alpha * v.y, v.z));
  // A uniform point of the spherical cap of mirror directions, then the half vector.
  const float angle = 2.0f * kPi * u.x;
  const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
  const float sine = std::sqrt(std::max(0.0f, 1.0f - z * z));
  const Vec3f h = Vec3f(sine * std::cos(angle), sine * std::sin(angle), z) + stretched;
  return glm::normalize(Vec3f(alpha * h.x, alpha * h.y, std::max(h.z, 1e-7f)));
}

float Ggx::visible_density(Vec3f v, Vec3f h) const {
  return masking(v) * std::max(0.0f, glm::dot(v, h)) * distribution(h) / v.z;
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

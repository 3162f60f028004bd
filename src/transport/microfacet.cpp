#include "transport/microfacet.hpp"

namespace lippmann {

float fresnel_dielectric(float cosine_incident, float eta) {
  const float ci = std::clamp(cosine_incident, 0.0f, 1.0f);
  const float sine2 = (1.0f - ci * ci) / squared(eta);
  if (sine2 >= 1.0f) return 1.0f;
  const float ct = std::sqrt(1.0f - sine2);
  const float parallel = (eta * ci - ct) / (eta * ci + ct), perpendicular = (ci - eta * ct) / (ci + eta * ct);
  return 0.5f * (squared(parallel) + squared(perpendicular));
}

}  // namespace lippmann

// Random walks of light between the facets of a rough metal, as a reference for multiple scattering: E. Heitz et al.,
// "Multiple-Scattering Microfacet BSDFs with the Smith Model", SIGGRAPH 2016, section 4.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "transport/microfacet.hpp"

namespace lippmann::test {

/// A ray between the facets of a Smith surface with uniformly distributed heights. `below` is the fraction of heights
/// below the ray.
struct FacetWalk {
  AnisotropicGgx ggx;
  Vec3f direction;
  std::mt19937& random;
  double below = 1.0;

  double number() { return std::uniform_real_distribution<double>()(random); }

  bool leaves() {
    const double away = static_cast<double>(ggx.lambda(direction)), lambda = direction.z > 0.0f ? away : -1.0 - away;
    const double free = direction.z > 0.0f ? std::pow(below, lambda) : 0.0, u = number();
    if (u >= 1.0 - free) return true;
    below = std::clamp(below / std::pow(1.0 - u, 1.0 / lambda), 1e-9, 1.0);
    return false;
  }

  Vec3f bounce(Vec3f f0) {
    const Vec3f back = -direction, h = ggx.sample_visible(back, {static_cast<float>(number()), static_cast<float>(number())});
    const float cosine = std::max(0.0f, glm::dot(back, h));
    direction = glm::normalize(direction + 2.0f * cosine * h);
    return f0 + (Vec3f(1.0f) - f0) * schlick_weight(cosine);
  }
};

/// Returns the light that leaves a metal after any number of bounces, with a standard error of at most 0.3 %. `view` is
/// a unit vector in local coordinates.
inline Vec3f walked_albedo(Vec3f view, Vec2f alpha, Vec3f f0) {
  constexpr int kWalks = 40'000, kMostBounces = 100;
  std::mt19937 random(5);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < kWalks; ++i) {
    FacetWalk walk{{alpha}, -view, random};
    Vec3f light(1.0f);
    for (int bounce = 0; bounce < kMostBounces && !walk.leaves(); ++bounce) light *= walk.bounce(f0);
    sum += glm::dvec3(light);
  }
  return Vec3f(sum / static_cast<double>(kWalks));
}

}  // namespace lippmann::test

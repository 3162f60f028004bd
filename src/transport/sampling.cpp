#include "transport/sampling.hpp"

namespace lippmann {

Vec2f sample_disc(Vec2f u) {
  const Vec2f p = 2.0f * u - Vec2f(1.0f);
  if (p.x == 0.0f && p.y == 0.0f) return Vec2f(0.0f);
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const float radius = wide ? p.x : p.y;
  const float angle = wide ? (kPi / 4) * (p.y / p.x) : kPi / 2 - (kPi / 4) * (p.x / p.y);
  return radius * Vec2f(std::cos(angle), std::sin(angle));
}

Vec3f sample_cosine(Vec2f u) {
  const Vec2f d = sample_disc(u);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1.0f - d.x * d.x - d.y * d.y))};
}

Vec2f sample_triangle(Vec2f u) {
  const float root = std::sqrt(u.x);
  return {root * (1.0f - u.y), root * u.y};
}

}  // namespace lippmann

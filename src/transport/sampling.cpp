#include "transport/sampling.hpp"

namespace lippmann {

Vec2f sample_triangle(Vec2f u) {
  const float root = std::sqrt(u.x);
  return {root * (1.0f - u.y), root * u.y};
}

}  // namespace lippmann

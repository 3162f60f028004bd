#pragma once

#include "lippmann/core/math.hpp"
#include "transport/ggx_albedo.hpp"

namespace lippmann::test {

inline const GgxAlbedo& albedo() {
  static const GgxAlbedo tables;
  return tables;
}

inline const Vec3f kNormal = glm::normalize(Vec3f(0.3f, -0.5f, 0.8f));

}  // namespace lippmann::test

#include "scene/directions.hpp"

namespace lippmann {
Vec3f direction_of(Vec3f v) {
  const Vec3d wide(v);
  return Vec3f(wide / glm::length(wide));
}

Quatf looking_along(Vec3f forward, Vec3f up) {
  const Vec3d z = -glm::normalize(Vec3d(forward));
  const Vec3d x = glm::normalize(glm::cross(glm::normalize(Vec3d(up)), z));
  const glm::dquat rotation = glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)));
  return Quatf(static_cast<float>(rotation.w), static_cast<float>(rotation.x), static_cast<float>(rotation.y),
               static_cast<float>(rotation.z));
}

}  // namespace lippmann

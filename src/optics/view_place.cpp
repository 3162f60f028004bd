#include "optics/view_place.hpp"

#include "optics/model.hpp"

namespace lippmann {
ViewPlaces::ViewPlaces(const Optics& optics) {
  const OpticsFacts facts = optics_facts(optics);
  vergence_ = std::isfinite(facts.viewing_distance_mm) ? 1.0 / static_cast<double>(facts.viewing_distance_mm) : 0.0;
  samples_per_mm_ = {1.0 / facts.samples.across_mm, 1.0 / facts.samples.down_mm};
}

std::optional<Vec2f> ViewPlaces::place_in_view(const Ray& ray, Vec3f point_mm) const {
  const glm::dvec3 origin(ray.origin), direction(ray.direction), point(point_mm);
  const glm::dvec2 slope = glm::dvec2(direction) / direction.z;
  const glm::dvec2 crossing = glm::dvec2(origin) - slope * origin.z;
  const double from_viewer = 1.0 - point.z * vergence_;
  if (!(from_viewer > 0.0)) return std::nullopt;
  const glm::dvec2 place = (glm::dvec2(point) - (crossing * vergence_ + slope) * point.z) / from_viewer;
  return Vec2f(place.x * samples_per_mm_.x, -place.y * samples_per_mm_.y);
}

}  // namespace lippmann

#include "denoise/view_geometry.hpp"

#include "optics/view_place.hpp"

namespace lippmann {

ViewGeometry::ViewGeometry(const Optics& optics, const ViewLayout& film) : grid_(film.grid) {
  const Vec2i panel = film_size(optics);
  size_ = lippmann::view_size(film, panel, "denoise");
  pixels_ = pixels_of_views(film, size_, panel);
  const ViewPlaces places(optics);
  vergence_ = static_cast<float>(places.vergence());
  samples_per_mm_ = Vec2f(places.samples_per_mm());
  largest_step_mm_ = std::max(1.0f / samples_per_mm_.x, 1.0f / samples_per_mm_.y);
  const Vec2i middle = size_ / 2;
  for (int view = 0; view < views(); ++view) {
    const std::size_t pixel = pixels_[(static_cast<std::size_t>(view) * size_.y + middle.y) * size_.x + middle.x];
    const auto width = static_cast<std::size_t>(panel.x);
    const Ray ray =
        ray_of_pixel(optics, Vec2f(static_cast<float>(pixel % width) + 0.5f, static_cast<float>(pixel / width) + 0.5f));
    const glm::dvec2 slope = glm::dvec2(ray.direction) / static_cast<double>(ray.direction.z);
    const glm::dvec2 place = glm::dvec2(ray.origin) - slope * static_cast<double>(ray.origin.z);
    const glm::dvec2 k = place * places.vergence() + slope;
    slope_.emplace_back(k.x, -k.y);
    first_.push_back(Vec2f(place.x, -place.y) * samples_per_mm_ - Vec2f(middle));
  }
}

}  // namespace lippmann

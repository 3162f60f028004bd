#include "denoise/film_views.hpp"

#include "optics/view_place.hpp"

namespace lippmann {

FilmViews::FilmViews(const Optics& optics, const ViewLayout& film) : film_(lippmann::film_size(optics)), grid_(film.grid) {
  size_ = view_size(film, film_, "denoise");
  pixels_ = pixels_of_views(film, size_, film_);
  const ViewPlaces places(optics);
  vergence_ = static_cast<float>(places.vergence());
  samples_per_mm_ = Vec2f(places.samples_per_mm());
  const Vec2i middle = size_ / 2;
  for (int view = 0; view < views(); ++view) {
    const std::uint32_t pixel = row(view, middle.y)[middle.x], width = static_cast<std::uint32_t>(film_.x);
    const Ray ray =
        ray_of_pixel(optics, Vec2f(static_cast<float>(pixel % width) + 0.5f, static_cast<float>(pixel / width) + 0.5f));
    const glm::dvec2 slope = glm::dvec2(ray.direction) / static_cast<double>(ray.direction.z);
    const glm::dvec2 place = glm::dvec2(ray.origin) - slope * static_cast<double>(ray.origin.z);
    const Vec2f at = Vec2f(place) * samples_per_mm_;
    sights_.push_back(
        {Vec2f(place * places.vergence() + slope), {at.x - static_cast<float>(middle.x), at.y + static_cast<float>(middle.y)}});
  }
}

}  // namespace lippmann

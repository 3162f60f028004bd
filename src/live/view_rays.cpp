#include "live/view_rays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "layout/cameras.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {
namespace {

/// Rays from the eye of a view. The parallax factor multiplies the difference between the slope of a ray and the slope of the
/// same pixel's ray in the middle view.
class EyeRays {
 public:
  EyeRays(const PlacedOptics& placed, const PageFacts& facts)
      : facts_(facts),
        middle_(design_viewer(placed.optics).slope_at_centre),
        parallax_(placed.depth_scale),
        z_front_(resolved_z_front_mm(placed.optics)) {}

  Ray operator()(int view, Vec2d pixel, Vec2i view_size) const {
    const Viewer eye = eye_of_view(facts_, view);
    const Vec2d point = facts_.window.point_at(pixel, view_size);
    const Vec2d slope = middle_ + parallax_ * (eye.slope_at_centre - middle_) - point * eye.vergence;
    Ray ray;
    ray.origin = Vec3f(Vec3d(point + z_front_ * slope, z_front_));
    ray.direction = glm::normalize(Vec3f(-Vec3d(slope, 1.0)));
    return ray;
  }

 private:
  const PageFacts& facts_;
  Vec2d middle_;
  double parallax_, z_front_;
};

class PixelRays {
 public:
  PixelRays(const Optics& optics, const ViewLayout& film, const PageFacts& facts)
      : optics_(optics), full_(facts.view_size), size_(film_size(optics)), pixels_(pixels_of_views(film, full_, size_)) {}

  Ray operator()(int view, Vec2d pixel, Vec2i view_size) const {
    const Vec2i at = glm::min(Vec2i(pixel / Vec2d(view_size) * Vec2d(full_)), full_ - 1);
    const std::uint32_t index = pixels_[(static_cast<std::size_t>(view) * full_.y + at.y) * full_.x + at.x];
    const auto width = static_cast<std::uint32_t>(size_.x);
    return ray_of_pixel(optics_, {static_cast<float>(index % width) + 0.5f, static_cast<float>(index / width) + 0.5f});
  }

 private:
  const Optics& optics_;
  Vec2i full_, size_;
  std::vector<std::uint32_t> pixels_;
};

/// Tiles without a view repeat the last view.
template <class Rays>
RayTable quilt_of(const Rays& rays, const PageFacts& facts, const Panel& panel, Vec2i view_size) {
  const ViewGrid& tiles = facts.tiles;
  return make_ray_table(panel, 1, [&](Vec2f pixel) {
    const Vec2i tile = Vec2i(pixel) / view_size;
    const int view = (tiles.rows - 1 - tile.y) * tiles.columns + tile.x;
    return rays(std::min(view, facts.grid.count() - 1), Vec2d(pixel) - Vec2d(tile * view_size), view_size);
  });
}

}  // namespace

Vec2i coarse_view_size(const PageFacts& facts, double pixels) {
  const Vec2d window = facts.window.size;
  const double pitch = std::sqrt(window.x * window.y * facts.grid.count() / pixels);
  return glm::clamp(Vec2i(window / pitch), Vec2i(1), facts.view_size);
}

Optics view_rays(const PlacedOptics& placed, const PageFacts& facts, Vec2i view_size) {
  Optics optics;
  optics.panel = {facts.tiles.columns * view_size.x, facts.tiles.rows * view_size.y,
                  static_cast<float>(facts.window.size.x / view_size.x)};
  optics.z_back_mm = placed.optics.z_back_mm;
  if (const std::optional<RenderedViews> views = rendered_views(placed.optics))
    optics.model = quilt_of(PixelRays(placed.optics, views->film, facts), facts, optics.panel, view_size);
  else
    optics.model = quilt_of(EyeRays(placed, facts), facts, optics.panel, view_size);
  return optics;
}

}  // namespace lippmann

#include "optics/view_place.hpp"

namespace lippmann {
namespace {

constexpr double kHalfRootOfThree = 0.8660254037844386;

struct Grid {
  double viewer_mm, across_mm, down_mm;
};

Grid grid_of(const Panel& panel, const LenticularSheet& sheet) {
  const double viewer = sheet.viewing_distance_mm, gap = sheet.gap_mm;
  const double to_plane = std::isfinite(viewer) ? viewer / (viewer + gap) : 1.0;  // rows meet at the viewer's height
  return {viewer, sheet.lens_pitch_mm / std::cos(static_cast<double>(sheet.slant)), panel.pixel_pitch_mm * to_plane};
}

Grid grid_of(const Panel&, const MicrolensArray& array) {
  const double pitch = array.lens_pitch_mm;
  return {array.viewing_distance_mm, pitch, array.packing == LensPacking::kHexagonal ? pitch * kHalfRootOfThree : pitch};
}

Grid grid_of(const Panel& panel, const MultiView& views) {
  return {views.distance_mm, panel.pixel_pitch_mm, static_cast<double>(panel.pixel_pitch_mm) * views.pixel_height};
}

Grid grid_of(const Panel& panel, const SingleView& view) {
  return {view.distance_mm, panel.pixel_pitch_mm, panel.pixel_pitch_mm};
}

Grid grid_of(const Panel& panel, const SlantedPanel& slanted) {
  const double pixel = 3.0 * panel.pixel_pitch_mm;
  return {slanted.distance_mm, pixel, pixel};
}

}  // namespace

ViewPlaces::ViewPlaces(const Optics& optics) {
  const Grid grid = std::visit([&](const auto& model) { return grid_of(optics.panel, model); }, optics.model);
  vergence_ = std::isfinite(grid.viewer_mm) ? 1.0 / grid.viewer_mm : 0.0;
  samples_per_mm_ = {1.0 / grid.across_mm, 1.0 / grid.down_mm};
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

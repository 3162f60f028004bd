#include "optics/slanted_sight.hpp"

#include <cmath>

namespace lippmann {

SlantedSight::SlantedSight(const Panel& panel, const SlantedPanel& slanted)
    : size_(panel.width, panel.height),
      pixel_mm_(panel.pixel_pitch_mm),
      per_column_(slanted.periods / size_.x),
      per_row_(slanted.tilt * slanted.periods / size_.y),
      center_(slanted.center),
      cone_(slanted.view_cone),
      distance_(slanted.distance_mm),
      inverted_(slanted.inverted),
      sub_pixels_(slanted.sub_pixels) {}

SlantedSight sight_of(const Panel& panel, const SlantedPanel& slanted) { return {panel, slanted}; }

Vec2d SlantedSight::pixel_at(Vec2d point_mm) const { return 0.5 * Vec2d(size_) + Vec2d(point_mm.x, -point_mm.y) / pixel_mm_; }

SlantedPoint SlantedSight::seen_from(const Viewer& viewer, Vec2d point_mm, int row) const {
  SlantedPoint point;
  point.lens = std::floor(phase(pixel_at(point_mm).x, size_.y - row - 0.5));
  const double x = point_mm.x + distance_ * viewer.slope_at(point_mm).x;
  const double v = cone_ > 0.0 ? std::atan(x / distance_) / cone_ + 0.5 : 0.5;
  point.in_zone = v >= 0.0 && v < 1.0;
  const double in_cone = v - std::floor(v);
  point.fraction = inverted_ ? 1.0 - in_cone : in_cone;
  return point;
}

Vec2f SlantedSight::offset(double column, int row, int color) const {
  const auto up = static_cast<std::size_t>((size_.y - 1 - row) & 3),
             odd = static_cast<std::size_t>(static_cast<int>(column) & 1);
  return sub_pixels_[up][odd][static_cast<std::size_t>(color)];
}

double SlantedSight::column_of(const SlantedPoint& point, int color, int row, double near_column) const {
  const Vec2f from_centre = offset(std::max(near_column, 0.0), row, color);
  const double up = size_.y - row - 0.5 + from_centre.y;
  return (point.lens + point.fraction + center_ - up * per_row_) / per_column_ - from_centre.x;
}

double SlantedSight::lens_of(int column, int row, int color) const {
  const Vec2f from_centre = offset(column, row, color);
  return std::floor(phase(column + 0.5 + from_centre.x, size_.y - row - 0.5 + from_centre.y));
}

}  // namespace lippmann

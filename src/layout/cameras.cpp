#include "layout/cameras.hpp"

#include <algorithm>
#include <cmath>

#include "layout/film_layout.hpp"

namespace lippmann {
std::optional<RenderedViews> rendered_views(const Optics& optics) {
  if (is_single_view(optics)) return RenderedViews{{LayoutKind::kStack, {1, 1}, {}}, view_cameras(optics)};
  if (!view_tiles(optics) && whole_pixels_per_lens(optics).x < 1) return std::nullopt;
  return RenderedViews{film_layout(optics, "optics"), view_cameras(optics)};
}

std::optional<double> common_baseline_mm(const ViewCameras& cameras, ViewGrid grid) {
  constexpr double kShare = 1e-4;  // a hundredth of what disparities of 100 pixels would show
  const auto eye = [&](int column, int row) { return cameras.eyes_mm[static_cast<std::size_t>(row * grid.columns + column)]; };
  const double baseline = grid.columns > 1 ? eye(1, 0).x - eye(0, 0).x : grid.rows > 1 ? eye(0, 1).y - eye(0, 0).y : 0.0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2d miss = eye(column, row) - eye(0, 0) - baseline * Vec2d(column, row);
      if (std::max(std::abs(miss.x), std::abs(miss.y)) > kShare * std::abs(baseline)) return std::nullopt;
    }
  return baseline;
}

std::string unknown_cameras(const LightField& field) {
  return field.positions ? "the cameras' positions have no unit, and their distance from the plane is not known"
                         : "the cameras of these views are unknown";
}

}  // namespace lippmann

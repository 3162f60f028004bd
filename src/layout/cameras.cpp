#include "layout/cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layout/film_layout.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// Returns how `camera` differs from `first` in a way that ViewCameras cannot express, such as "is rotated against that of view
/// 0". Returns an empty text if there is no such difference.
std::string difference(const PosedCamera& camera, const PosedCamera& first) {
  constexpr double kSameRotation = 1e-6, kSameFocal = 1e-6, kSameHeight = 1e-4;
  double turn = 0.0;
  for (int axis = 0; axis < 3; ++axis) turn = std::max(turn, glm::length(camera.rotation[axis] - first.rotation[axis]));
  if (turn > kSameRotation) return "is rotated against that of view 0";
  if (glm::length(camera.focal_px / first.focal_px - 1.0) > kSameFocal)
    return fmt::format("has the focal lengths {}x{} pixels, and that of view 0 has {}x{}", camera.focal_px.x, camera.focal_px.y,
                       first.focal_px.x, first.focal_px.y);
  const Vec3d offset = glm::transpose(first.rotation) * (camera.position_mm - first.position_mm);
  if (std::abs(offset.z) > kSameHeight * glm::length(offset)) return "is not in one plane with that of view 0";
  return {};
}

}  // namespace

std::optional<RenderedViews> rendered_views(const Optics& optics) {
  if (is_single_view(optics)) return RenderedViews{{LayoutKind::kStack, {1, 1}, {}}, view_cameras(optics)};
  if (!view_tiles(optics) && whole_pixels_per_lens(optics).x < 1) return std::nullopt;
  return RenderedViews{film_layout(optics, "optics"), view_cameras(optics)};
}

std::optional<double> common_baseline_mm(const ViewCameras& cameras, ViewGrid grid) {
  // Largest deviation of an eye from the grid, relative to the baseline. It changes a disparity of 100 pixels by 1/100 pixel.
  constexpr double kShare = 1e-4;
  const auto eye = [&](int column, int row) { return cameras.eyes_mm[static_cast<std::size_t>(row * grid.columns + column)]; };
  const double baseline = grid.columns > 1 ? eye(1, 0).x - eye(0, 0).x : grid.rows > 1 ? eye(0, 1).y - eye(0, 0).y : 0.0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2d miss = eye(column, row) - eye(0, 0) - baseline * Vec2d(column, row);
      if (std::max(std::abs(miss.x), std::abs(miss.y)) > kShare * std::abs(baseline)) return std::nullopt;
    }
  return baseline;
}

Vec2d sum_of_steps(const std::vector<Vec2d>& eyes, ViewGrid grid, bool across) {
  Vec2d sum(0.0);
  const auto eye = [&](int column, int row) { return eyes[static_cast<std::size_t>(row * grid.columns + column)]; };
  if (across)
    for (int row = 0; row < grid.rows; ++row) sum += eye(grid.columns - 1, row) - eye(0, row);
  else
    for (int column = 0; column < grid.columns; ++column) sum += eye(column, grid.rows - 1) - eye(column, 0);
  return sum;
}

double mean_step(const std::vector<Vec2d>& eyes, ViewGrid grid) {
  if (grid.columns > 1) return std::abs(sum_of_steps(eyes, grid, true).x) / ((grid.columns - 1) * grid.rows);
  return grid.rows > 1 ? std::abs(sum_of_steps(eyes, grid, false).y) / (grid.rows - 1) : 0.0;
}

std::string unknown_cameras(const LightField& field) {
  if (field.poses) {
    const std::string shared = "the cameras do not share a plane and a window";
    for (std::size_t view = 1; view < field.poses->size(); ++view)
      if (const std::string text = difference((*field.poses)[view], field.poses->front()); !text.empty())
        return fmt::format("{}: the camera of view {} {}", shared, view, text);
    return shared + ": their principal points do not move with the eyes";
  }
  return field.positions ? "the camera positions have no unit, and their distance from the focal plane is unknown"
                         : "the cameras of these views are unknown";
}

}  // namespace lippmann

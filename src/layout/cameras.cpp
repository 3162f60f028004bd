#include "layout/cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "layout/film_layout.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

void require_length(double length_mm, const char* parameter) {
  constexpr double kLeast = 1e-6, kMost = 1e9;
  if (!(length_mm >= kLeast && length_mm <= kMost))
    throw usage_error(parameter, fmt::format("is {} mm", length_mm), fmt::format("{} to {} mm", kLeast, kMost));
}

/// Adds the vectors from the first to the last eye of every row, or of every column if `across` is false.
Vec2d sum_of_steps(const std::vector<Vec2d>& eyes, ViewGrid grid, bool across) {
  Vec2d sum(0.0);
  const auto eye = [&](int column, int row) { return eyes[static_cast<std::size_t>(row * grid.columns + column)]; };
  if (across)
    for (int row = 0; row < grid.rows; ++row) sum += eye(grid.columns - 1, row) - eye(0, row);
  else
    for (int column = 0; column < grid.columns; ++column) sum += eye(column, grid.rows - 1) - eye(column, 0);
  return sum;
}

/// Multiplies positions by `scale` and moves their mean to (0, 0). Reverses axes where necessary, so that x increases along the
/// rows of `grid`, and y along the columns.
std::vector<Vec2d> scaled_eyes(const std::vector<Vec2d>& positions, ViewGrid grid, double scale) {
  Vec2d middle(0.0);
  for (const Vec2d& position : positions) middle += position / static_cast<double>(positions.size());
  const Vec2d signs(sum_of_steps(positions, grid, true).x < 0.0 ? -1.0 : 1.0,
                    sum_of_steps(positions, grid, false).y < 0.0 ? -1.0 : 1.0);
  std::vector<Vec2d> eyes;
  for (const Vec2d& position : positions) eyes.push_back(scale * signs * (position - middle));
  return eyes;
}

/// Returns the distance of each eye from the lowest eye along an axis, divided by the least distance between eyes. Returns none
/// if these quotients are not whole numbers.
std::optional<std::vector<int>> places_along(int axis, const std::vector<Vec2d>& eyes, double extent) {
  // Eyes closer than kSamePlace * extent count as one position. kRegular: allowed deviation of a quotient from a whole number,
  // because calibrated cameras are not exactly regular.
  constexpr double kSamePlace = 1e-3, kRegular = 0.05, kMostSteps = 4096.0;
  std::vector<double> sorted;
  for (const Vec2d& eye : eyes) sorted.push_back(eye[axis]);
  std::sort(sorted.begin(), sorted.end());
  double step = extent;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (const double gap = sorted[i] - sorted[i - 1]; gap > kSamePlace * extent) step = std::min(step, gap);
  std::vector<int> places;
  for (const Vec2d& eye : eyes) {
    const double place = (eye[axis] - sorted.front()) / step;
    if (!(place < kMostSteps) || std::abs(place - std::round(place)) > kRegular) return std::nullopt;
    places.push_back(static_cast<int>(std::round(place)));
  }
  return places;
}

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

double mean_step(const std::vector<Vec2d>& eyes, ViewGrid grid) {
  if (grid.columns > 1) return std::abs(sum_of_steps(eyes, grid, true).x) / ((grid.columns - 1) * grid.rows);
  return grid.rows > 1 ? std::abs(sum_of_steps(eyes, grid, false).y) / (grid.rows - 1) : 0.0;
}

ViewCameras cameras_as_stated(const StatedCameras& stated, const LightField& field, const std::string& where) {
  require_length(stated.baseline_mm, "baseline");
  require_length(stated.focal_length_mm, "focal-length");
  require_length(stated.sensor_width_mm, "sensor-width");
  require_length(stated.focus_distance_mm, "focus-distance");
  const ViewGrid grid = field.grid;
  const double pixel_mm =
      stated.sensor_width_mm * stated.focus_distance_mm / (stated.focal_length_mm * static_cast<double>(field.view_size.x));
  ViewCameras cameras{stated.focus_distance_mm, Vec2d(pixel_mm), 0.5 * Vec2d(field.view_size), {}};
  for (int view = 0; view < grid.count(); ++view)
    cameras.eyes_mm.push_back(stated.baseline_mm *
                              (Vec2d(view % grid.columns, view / grid.columns) - 0.5 * Vec2d(grid.columns - 1, grid.rows - 1)));
  if (!field.positions || grid.count() == 1) return cameras;
  const double step = mean_step(*field.positions, grid);
  const std::vector<Vec2d> eyes = scaled_eyes(*field.positions, grid, stated.baseline_mm / step);
  const auto is_finite = [](const Vec2d& eye) { return std::isfinite(eye.x) && std::isfinite(eye.y); };
  if (!std::all_of(eyes.begin(), eyes.end(), is_finite))
    throw Error(where, "the positions in its file names are equal in all columns", "a different position for each column");
  // If the positions match a regular grid up to rounding, the exact grid is used.
  const ViewCameras placed{cameras.distance_mm, cameras.pixel_mm, cameras.centre_px, eyes};
  return common_baseline_mm(placed, grid) ? cameras : placed;
}

void state_cameras(LightField& field, const StatedCameras& stated, const std::string& where) {
  if (field.cameras || field.poses)
    throw usage_error("baseline", "has no effect: " + where + " states its cameras", "views whose cameras are unknown");
  field.cameras = cameras_as_stated(stated, field, where);
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

void warn_of_missing_cameras(const std::vector<Vec2d>& eyes, const std::string& where, const FormatOptions& options) {
  double extent = 0.0;
  for (const Vec2d& eye : eyes) extent = std::max(extent, glm::distance(eye, eyes.front()));
  if (!options.warn || !(extent > 0.0)) return;
  const std::optional<std::vector<int>> columns = places_along(0, eyes, extent), rows = places_along(1, eyes, extent);
  if (!columns || !rows) return;
  std::set<std::pair<int, int>> taken;  // (row, column)
  for (std::size_t i = 0; i < eyes.size(); ++i) taken.emplace((*rows)[i], (*columns)[i]);
  const ViewGrid grid{*std::max_element(columns->begin(), columns->end()) + 1,
                      *std::max_element(rows->begin(), rows->end()) + 1};
  const int missing = grid.count() - static_cast<int>(taken.size());
  if (missing == 0 || 4 * missing > grid.count()) return;
  int place = 0;
  while (taken.contains({place / grid.columns, place % grid.columns})) ++place;
  options.warn(
      fmt::format("{}: the camera of column {}, row {} (from 0, from the lower left) is missing{}, so the {} views "
                  "do not form a grid of {}x{}",
                  where, place % grid.columns, place / grid.columns,
                  missing > 1 ? fmt::format(", and {} more", missing - 1) : "", eyes.size(), grid.columns, grid.rows));
}

}  // namespace lippmann

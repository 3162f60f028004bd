#include "formats/stated_cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

void require_length(double length_mm, const char* parameter) {
  constexpr double kLeast = 1e-6, kMost = 1e9;
  if (!(length_mm >= kLeast && length_mm <= kMost))
    throw usage_error(parameter, fmt::format("is {} mm", length_mm), fmt::format("{} to {} mm", kLeast, kMost));
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

}  // namespace

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

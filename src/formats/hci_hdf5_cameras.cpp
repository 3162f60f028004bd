#include "formats/hci_hdf5_cameras.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr double kMmPerMetre = 1000.0;

std::optional<double> number_between(const std::map<std::string, double>& attributes, const char* name, double least,
                                     double most, const std::string& where) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return std::nullopt;
  if (!(found->second >= least && found->second <= most))
    throw Error(where, fmt::format("its attribute {} is {}", name, found->second),
                fmt::format("a number from {} to {}", least, most));
  return found->second;
}

/// Position of a view relative to the grid's middle, in steps from camera to camera.
Vec2d place_in_grid(ViewGrid grid, int view) {
  return Vec2d(view % grid.columns, view / grid.columns) - 0.5 * Vec2d(grid.columns - 1, grid.rows - 1);
}

}  // namespace

bool set_hdf5_cameras(const std::map<std::string, double>& attributes, LightField& field, const std::string& where) {
  // The bounds are far beyond the values of any camera. They only serve to refuse damaged files.
  constexpr double kLeast = 1e-6, kMost = 1e6, kMostShift = 1e4, kLeastShift = 1e-6, kEqual = 1e-6;
  const ViewGrid grid = field.grid;
  const auto across = number_between(attributes, "dH", kLeast, kMost, where);
  const auto along = number_between(attributes, "dV", kLeast, kMost, where);
  const auto focal = number_between(attributes, "focalLength", kLeast, kMost, where);
  const double shift = number_between(attributes, "shift", -kMostShift, kMostShift, where).value_or(0.0);
  if (!focal || (grid.columns > 1 && !across) || (grid.rows > 1 && !along) || (!across && !along)) return false;
  // In a grid with a single row or column, the one known distance is used for both axes.
  const Vec2d step_mm =
      kMmPerMetre * Vec2d(grid.columns > 1 || !along ? *across : *along, grid.rows > 1 || !across ? *along : *across);
  const bool shares_plane = shift >= kLeastShift && std::abs(step_mm.x / step_mm.y - 1.0) < kEqual;
  const Vec2d middle = 0.5 * Vec2d(field.view_size);
  if (shares_plane)
    field.cameras = {step_mm.x * *focal / shift, Vec2d(step_mm.x / shift), middle, {}};
  else
    field.poses.emplace();
  for (int view = 0; view < grid.count(); ++view) {
    const Vec2d place = place_in_grid(grid, view), eye_mm = place * step_mm;
    if (shares_plane)
      field.cameras->eyes_mm.push_back(eye_mm);
    else
      field.poses->push_back({.size = field.view_size,
                              .focal_px = Vec2d(*focal),
                              .principal_px = middle + shift * Vec2d(place.x, -place.y),
                              .position_mm = Vec3d(eye_mm, 0.0)});
  }
  return true;
}

float z_of_hdf5_depth(float depth, const LightField& field) {
  constexpr float kNothing = 1e9f;  // Blender writes 1e10 where there is no surface
  if (!(depth > 0.0f && depth < kNothing)) return -kInfinity;
  const double plane_mm = field.cameras ? field.cameras->distance_mm : 0.0;
  return static_cast<float>(plane_mm - kMmPerMetre * static_cast<double>(depth));
}

}  // namespace lippmann

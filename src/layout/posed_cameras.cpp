#include "layout/posed_cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/film_views.hpp"

namespace lippmann {

std::vector<PosedCamera> posed_cameras(const LightField& field, const std::string& where) {
  if (field.poses) return *field.poses;
  if (!field.cameras)
    throw Error(where, "cannot be written: " + unknown_cameras(field),
                "pictures with render's report.json beside them, or a folder whose files state cameras");
  const ViewCameras& cameras = *field.cameras;
  std::vector<PosedCamera> posed;
  for (const Vec2d& eye : cameras.eyes_mm) {
    const Vec2d straight_ahead = eye / cameras.pixel_mm * Vec2d(1.0, -1.0);
    posed.push_back({field.view_size, cameras.distance_mm / cameras.pixel_mm, cameras.centre_px + straight_ahead,
                     glm::dmat3(1.0), Vec3d(eye, cameras.distance_mm)});
  }
  return posed;
}

std::optional<ViewCameras> shared_plane(const std::vector<PosedCamera>& cameras) {
  constexpr double kSameRotation = 1e-6, kSamePlane = 1e-4, kSameCentre_px = 0.01;
  const PosedCamera& first = cameras.front();
  const auto from_first = [&](const PosedCamera& c) {
    return glm::transpose(first.rotation) * (c.position_mm - first.position_mm);
  };
  // If the eye moves by m mm, the principal point shifts by focal_px * m / distance, with `distance` from the eyes to the plane
  // with zero disparity. The longest shift gives the distance.
  double distance = 0.0, longest = 0.0, extent = 0.0;
  for (const PosedCamera& c : cameras) {
    const Vec3d by_mm = from_first(c);
    const Vec2d by_px = (c.principal_px - first.principal_px) * Vec2d(1.0, -1.0);
    extent = std::max(extent, glm::length(by_mm));
    for (const int axis : {0, 1}) {
      if (!(std::abs(by_px[axis]) > longest)) continue;
      longest = std::abs(by_px[axis]);
      distance = first.focal_px[axis] * by_mm[axis] / by_px[axis];
    }
  }
  if (!(distance > 0.0) || !std::isfinite(distance)) return std::nullopt;
  ViewCameras shared{distance, distance / first.focal_px, first.principal_px, {}};
  for (const PosedCamera& c : cameras) {
    const Vec3d eye = from_first(c);
    const Vec2d centre = c.principal_px - Vec2d(eye) / shared.pixel_mm * Vec2d(1.0, -1.0);
    double turned = 0.0;
    for (int axis = 0; axis < 3; ++axis) turned = std::max(turned, glm::length(c.rotation[axis] - first.rotation[axis]));
    if (turned > kSameRotation || std::abs(eye.z) > kSamePlane * extent || c.size != first.size ||
        glm::length(c.focal_px / first.focal_px - 1.0) > kSameRotation ||
        glm::distance(centre, first.principal_px) > kSameCentre_px)
      return std::nullopt;
    shared.eyes_mm.emplace_back(eye);
  }
  // Moves the origin from the first eye to the point that appears in the middle of the views.
  const Vec2d middle = (0.5 * Vec2d(first.size) - shared.centre_px) * shared.pixel_mm * Vec2d(1.0, -1.0);
  for (Vec2d& eye : shared.eyes_mm) eye -= middle;
  shared.centre_px = 0.5 * Vec2d(first.size);
  return shared;
}

void place_in_world(LightField& field, const Affine3f& world_from_display, const Vec3d& origin) {
  constexpr double kPerUnit = 1000.0;
  std::vector<PosedCamera> cameras = posed_cameras(field, "optics");
  const glm::dmat3 linear(world_from_display.linear);
  const glm::dmat3 turn(glm::normalize(linear[0]), glm::normalize(linear[1]), glm::normalize(linear[2]));
  for (PosedCamera& camera : cameras) {
    camera.position_mm = kPerUnit * (origin + linear * camera.position_mm + Vec3d(world_from_display.translation));
    camera.rotation = turn * camera.rotation;
  }
  const double scale = kPerUnit * glm::length(linear[0]);
  if (field.depth)
    for (float& z : field.depth->data) z = static_cast<float>(-scale * planar_depth_mm(field, z));
  field.cameras.reset();
  field.poses = std::move(cameras);
}

PosedCamera camera_in_world(const Optics& single_view, const Affine3f& world_from_display, const Vec3d& origin) {
  LightField field;
  field.view_size = film_size(single_view);
  field.cameras = view_cameras(single_view);
  place_in_world(field, world_from_display, origin);
  return field.poses->front();
}

double planar_depth_mm(const LightField& field, float z) {
  return (field.cameras ? field.cameras->distance_mm : 0.0) - static_cast<double>(z);
}

glm::dmat3 checked_rotation(const double (&rows)[9], const std::string& where) {
  constexpr double kTolerance = 1e-3;
  glm::dmat3 rotation(1.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) rotation[column][row] = rows[3 * row + column];
  const glm::dmat3 product = glm::transpose(rotation) * rotation;
  double error = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) error = std::max(error, std::abs(product[column][row] - (row == column ? 1.0 : 0.0)));
  if (!(error <= kTolerance))
    throw Error(where, fmt::format("is not a rotation: its columns deviate from perpendicular unit vectors by {:.3g}", error),
                fmt::format("a rotation matrix exact to {}", kTolerance));
  if (!(glm::determinant(rotation) > 0.0))
    throw Error(where, "is left-handed: it mirrors the camera's axes", "a rotation with determinant 1");
  rotation[0] = glm::normalize(rotation[0]);
  rotation[1] = glm::normalize(rotation[1] - glm::dot(rotation[1], rotation[0]) * rotation[0]);
  rotation[2] = glm::cross(rotation[0], rotation[1]);
  return rotation;
}

}  // namespace lippmann

// A pinhole camera with any pose, as in the data sets of NeRF, COLMAP and LLFF.
//
// A world point p has the camera coordinates c = transpose(rotation) (p - position), with x to the right, y up and z backwards
// (the axes of Blender and NeRF). The point appears at principal_px + focal_px (c.x, -c.y) / -c.z, in pixels from the top left
// corner; pixel centres lie at +0.5.
#pragma once

#include <string>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct PosedCamera {
  Vec2i size{0, 0};  ///< size of the camera's picture
  Vec2d focal_px{0.0}, principal_px{0.0};
  glm::dmat3 rotation{1.0};  ///< columns: the camera's x, y and z axes in world coordinates
  Vec3d position_mm{0.0};
};

/// Returns the pixel that shows a point. The result is meaningless for points behind the camera.
inline Vec2d projected(const PosedCamera& camera, Vec3d point_mm) {
  const Vec3d c = glm::transpose(camera.rotation) * (point_mm - camera.position_mm);
  return camera.principal_px + camera.focal_px * Vec2d(c.x, -c.y) / -c.z;
}

/// Returns the point that a pixel shows at a depth. The depth is measured along the camera's axis.
inline Vec3d unprojected(const PosedCamera& camera, Vec2d pixel, double depth_mm) {
  const Vec2d slope = (pixel - camera.principal_px) / camera.focal_px * Vec2d(1.0, -1.0);
  return camera.position_mm + camera.rotation * (depth_mm * Vec3d(slope, -1.0));
}

/// Returns a rotation matrix whose elements are given row by row. Throws Error naming `where` if the columns of the matrix
/// deviate from orthonormal vectors by more than 1e-3, or if the matrix contains a reflection.
glm::dmat3 checked_rotation(const double (&rows)[9], const std::string& where);

}  // namespace lippmann

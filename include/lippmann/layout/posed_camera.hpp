// A pinhole camera of any pose, as in the data sets of NeRF, COLMAP and LLFF.
//
// A point p of the world lies at c = transpose(rotation) (p - position) in the camera's frame: x to the right, y up, z
// backwards (the axes of Blender and NeRF). Its picture shows it at principal_px + focal_px (c.x, -c.y) / -c.z, counted from
// the top left corner; centres of pixels lie at +0.5.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

struct PosedCamera {
  Vec2i size{0, 0};  ///< of its picture
  Vec2d focal_px{0.0}, principal_px{0.0};
  glm::dmat3 rotation{1.0};  ///< columns: the directions of the camera's x, y and z in the world
  Vec3d position_mm{0.0};
};

/// Returns the pixel that shows a point of the world; behind the camera, the result has no meaning.
inline Vec2d projected(const PosedCamera& camera, Vec3d point_mm) {
  const Vec3d c = glm::transpose(camera.rotation) * (point_mm - camera.position_mm);
  return camera.principal_px + camera.focal_px * Vec2d(c.x, -c.y) / -c.z;
}

/// The point of the world at a planar depth, which is measured along the camera's axis, behind a place of the picture.
inline Vec3d unprojected(const PosedCamera& camera, Vec2d pixel, double depth_mm) {
  const Vec2d slope = (pixel - camera.principal_px) / camera.focal_px * Vec2d(1.0, -1.0);
  return camera.position_mm + camera.rotation * (depth_mm * Vec3d(slope, -1.0));
}

}  // namespace lippmann

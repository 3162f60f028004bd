// Converts between cameras with arbitrary poses and parallel cameras whose views show the same rectangle of a plane
// (ViewCameras).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/posed_camera.hpp"

namespace lippmann {

/// Returns ViewCameras in the frame of the first camera, or none unless all cameras are parallel, have their eyes in
/// one plane and show the same rectangle of another plane. `cameras` must not be empty.
std::optional<ViewCameras> shared_plane(const std::vector<PosedCamera>& cameras);

/// Returns the camera of a single view in the world. Lengths are in thousandths of the world's unit, and `origin` is
/// added to the position. world_from_display must be a similarity.
PosedCamera camera_in_world(const Optics& single_view, const Affine3f& world_from_display, const Vec3d& origin);

/// Converts z as in LightField::depth to planar depth in mm. Results that are <= 0 or not finite mean no surface.
double planar_depth_mm(const LightField& field, float z);

}  // namespace lippmann

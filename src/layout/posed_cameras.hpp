// Conversions between cameras of any pose and cameras that share a plane.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/posed_camera.hpp"

namespace lippmann {

/// The inverse, in the frame of the first camera: nullopt unless all cameras are parallel, stand in one plane and look through
/// one rectangle. `cameras` has at least one.
std::optional<ViewCameras> shared_plane(const std::vector<PosedCamera>& cameras);

/// The camera of a single view in the world, with lengths in thousandths of the world's unit; `origin` is added to it. The
/// world's transform is a similarity.
PosedCamera camera_in_world(const Optics& single_view, const Affine3f& world_from_display, const Vec3d& origin);

/// The planar depth in mm of a light field's z; not above 0 or not finite: nothing is there.
double planar_depth_mm(const LightField& field, float z);

/// The rotation of a matrix given row by row. Throws Error naming `where` if its columns are not perpendicular unit vectors to
/// 1e-3, or if it mirrors.
glm::dmat3 checked_rotation(const double (&rows)[9], const std::string& where);

}  // namespace lippmann

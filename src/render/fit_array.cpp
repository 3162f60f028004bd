#include "render/fit_array.hpp"

#include <algorithm>

namespace lippmann {
namespace {

/// Without a camera the viewer stands this many panel heights away, as one does before a picture.
constexpr float kViewerHeights = 3.0f;
/// And the array is this much higher than what it shows.
constexpr float kMargin = 1.1f;

/// Rotation and place of a node, its scale taken out.
Affine3f rigid(const Affine3f& a) {
  const Vec3f z = glm::normalize(a.linear[2]);
  const Vec3f y = glm::normalize(a.linear[1] - glm::dot(a.linear[1], z) * z);
  return {Mat3f(glm::cross(y, z), y, z), a.translation};
}

/// How far in front of the camera the array's plane goes: the focus distance, or the middle of what is in front of it.
float plane_distance(const Camera& camera, const Affine3f& world_from_camera, const Bounds3f& bounds) {
  if (camera.focus_distance > 0.0f) return camera.focus_distance;
  if (bounds.empty()) return 1.0f;
  const Bounds3f seen = transform_bounds(inverse(world_from_camera), bounds);  // the camera looks along -z
  const float nearest = std::max(0.0f, -seen.upper.z), farthest = -seen.lower.z;
  return farthest > 0.0f ? std::max(0.5f * (nearest + farthest), 1e-3f * farthest) : 1.0f;
}

FittedArray fit_to_camera(const Camera& camera, const ResolvedScene& resolved, const Bounds3f& bounds) {
  FittedArray array;
  array.origin = camera.focus_distance > 0.0f ? FittedArray::Origin::kFocus : FittedArray::Origin::kSceneCenter;
  array.node = camera.node;
  array.viewing_distance = plane_distance(camera, rigid(resolved.of(camera.node)), bounds);
  array.node_from_plane.translation = {0.0f, 0.0f, -array.viewing_distance};
  array.plane_height = 2.0f * array.viewing_distance * std::tan(0.5f * camera.vertical_fov);
  return array;
}

FittedArray fit_to_bounds(const Bounds3f& bounds) {
  FittedArray array;
  array.origin = FittedArray::Origin::kBounds;
  if (!bounds.empty()) {
    array.node_from_plane.translation = bounds.center();
    const float extent = std::max(bounds.size().x, bounds.size().y);
    array.plane_height = kMargin * (extent > 0.0f ? extent : std::max(bounds.size().z, 1.0f));
  }
  array.viewing_distance = kViewerHeights * array.plane_height;
  return array;
}

}  // namespace

FittedArray fit_array(const Scene& scene) {
  if (scene.display) {
    FittedArray array;
    array.node = scene.display->node;
    array.plane_height = scene.display->plane_height;
    array.viewing_distance = scene.display->viewing_distance;
    return array;
  }
  const ResolvedScene resolved = evaluate(scene, scene.timeline.time(0));
  const Bounds3f bounds = finite_bounds(scene, resolved);
  return scene.cameras.empty() ? fit_to_bounds(bounds) : fit_to_camera(scene.cameras.front(), resolved, bounds);
}

Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved) {
  const Affine3f plane = rigid(resolved.of(array.node)) * array.node_from_plane;
  return {plane.linear * units_per_mm, plane.translation};
}

}  // namespace lippmann

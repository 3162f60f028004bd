#include "render/fit_array.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "scene/default_view.hpp"

namespace lippmann {
namespace {

/// A plane much nearer to the camera than that would make all of the scene background.
constexpr float kNearestPlane = 0.05f;  // diagonals of the scene
constexpr float kDefaultFov = radians(45.0f);
constexpr float kDefaultMargin = 1.1f;  ///< what the default camera sees, over what there is to see

/// The rotation, place and one scale of a node's transform.
Affine3f similarity(const Affine3f& a) {
  const float scale = uniform_scale(a);
  if (!(scale > 0.0f) || !std::isfinite(scale))
    throw Error("scene", "the node that carries the lens array is scaled to nothing", "a scale other than 0");
  const Vec3f z = glm::normalize(a.linear[2]);
  const Vec3f y = glm::normalize(a.linear[1] - glm::dot(a.linear[1], z) * z);
  return {scale * Mat3f(glm::cross(y, z), y, z), a.translation};
}

/// The array square to a camera's view, at a distance, filling it.
void place_before_camera(FittedArray& array, float distance, float vertical_fov) {
  array.node_from_plane = {Mat3f(1.0f), {0.0f, 0.0f, -distance}};
  array.plane_height = 2.0f * distance * std::tan(0.5f * vertical_fov);
  array.viewing_distance = distance;
}

std::string camera_name(const Camera& camera) {
  return camera.name.empty() ? std::string("the camera") : fmt::format("camera '{}'", camera.name);
}

// ---- The rules, in order ------------------------------------------------------------------------------------------------

FittedArray as_placed(const DisplayPlacement& display) {
  FittedArray array;
  array.origin = FittedArray::Origin::kPlaced;
  array.node = display.node;
  array.plane_height = display.plane_height;
  array.viewing_distance = display.viewing_distance;
  array.how = fmt::format("The scene places the array: {:.4g} units high, viewed from {:.4g} units.", display.plane_height,
                          display.viewing_distance);
  return array;
}

FittedArray at_focus(const Camera& camera) {
  FittedArray array;
  array.origin = FittedArray::Origin::kFocus;
  array.node = camera.node;
  place_before_camera(array, camera.focus_distance, camera.vertical_fov);
  array.how = fmt::format("The array is at the focus of {}, {:.4g} units away, and fills its view.", camera_name(camera),
                          camera.focus_distance);
  return array;
}

/// seen: the scene's bounds in the camera's frame, which looks along -z. Of a scene all around the camera, a room, only what is
/// in front of it counts: its middle is half way to the far wall.
FittedArray half_way_through(const Camera& camera, const Bounds3f& seen) {
  FittedArray array;
  array.origin = FittedArray::Origin::kSceneCenter;
  array.node = camera.node;
  float distance = 1.0f;
  if (!seen.empty()) {
    const float nearest = std::max(0.0f, -seen.upper.z), farthest = std::max(0.0f, -seen.lower.z);
    const float diagonal = glm::length(seen.size());
    distance = std::max(0.5f * (nearest + farthest), kNearestPlane * (diagonal > 0.0f ? diagonal : 1.0f));
  }
  place_before_camera(array, distance, camera.vertical_fov);
  array.how = fmt::format("The array goes through the middle of the scene, {:.4g} units in front of {}, and fills its view.",
                          distance, camera_name(camera));
  return array;
}

/// Bounds along the axes of a frame of all that the animation shows, at up to 32 of its frames.
Bounds3f bounds_over_animation(const Scene& scene, const Affine3f& frame_from_world) {
  constexpr int kSampledFrames = 32;
  Bounds3f bounds;
  const int step = std::max(1, scene.timeline.frame_count / kSampledFrames);
  for (int frame = 0; frame < scene.timeline.frame_count; frame += step)
    bounds.add(finite_bounds(scene, evaluate(scene, scene.timeline.time(frame)), frame_from_world));
  return bounds;
}

/// So far away that the nearest face of all that ever is in the scene fits into the picture.
FittedArray without_camera(const Scene& scene, float aspect) {
  FittedArray array;
  array.origin = FittedArray::Origin::kBounds;
  const Mat3f view = glm::mat3_cast(default_view());
  const Bounds3f bounds = bounds_over_animation(scene, {glm::transpose(view), Vec3f(0.0f)});
  const Vec3f size = bounds.empty() ? Vec3f(1.0f) : bounds.size();
  const float face_height = kDefaultMargin * std::max(size.y, size.x / aspect);
  const float tangent = std::tan(0.5f * kDefaultFov);
  const float distance = 0.5f * size.z + 0.5f * (face_height > 0.0f ? face_height : std::max(size.z, 1.0f)) / tangent;
  place_before_camera(array, distance, kDefaultFov);
  array.node_from_plane = {view, bounds.empty() ? Vec3f(0.0f) : view * bounds.center()};
  array.how = fmt::format(
      "The scene has no camera: the array goes through its middle and is viewed from {:.4g} units away, a "
      "little from above and from the right.",
      distance);
  return array;
}

/// How far the scene reaches in front of the plane and behind it, as far as the viewer sees.
void measure_depth(FittedArray& array, const Scene& scene, const ResolvedScene& resolved) {
  const Affine3f world_from_plane = similarity(resolved.of(array.node)) * array.node_from_plane;
  const Bounds3f bounds = finite_bounds(scene, resolved, inverse(world_from_plane));
  if (bounds.empty()) return;
  array.depth_front = std::min(bounds.upper.z, array.viewing_distance);
  array.depth_back = std::min(bounds.lower.z, array.viewing_distance);
}

/// Refuses arrays in whose space floats no longer tell the corners of small things apart, or overflow.
void check_extent(const FittedArray& array, const ResolvedScene& resolved) {
  constexpr float kSmallest = 1e-9f, kLargest = 1e15f;
  const Affine3f world_from_node = resolved.of(array.node);
  const float height = array.plane_height * uniform_scale(world_from_node);
  if (!(height >= kSmallest && height <= kLargest))
    throw Error("scene", fmt::format("the lens array fitted to it would be {:.4g} units high", std::abs(height)),
                fmt::format("scenes of {:g} to {:g} units", kSmallest, kLargest));
  const float away = glm::length(transform_point(world_from_node, array.node_from_plane.translation));
  if (!(away <= kLargest))
    throw Error("scene", fmt::format("the lens array would be {:.4g} units away from the origin", std::abs(away)),
                fmt::format("at most {:g}", kLargest));
}

FittedArray place(const Scene& scene, const ResolvedScene& resolved, float aspect) {
  if (scene.display) return as_placed(*scene.display);
  if (scene.cameras.empty()) return without_camera(scene, aspect);
  const Camera& camera = scene.cameras.front();
  if (camera.focus_distance > 0.0f) return at_focus(camera);
  return half_way_through(camera, finite_bounds(scene, resolved, inverse(similarity(resolved.of(camera.node)))));
}

}  // namespace

FittedArray fit_array(const Scene& scene, float aspect) {
  const ResolvedScene resolved = evaluate(scene, scene.timeline.time(0));
  FittedArray array = place(scene, resolved, aspect);
  check_extent(array, resolved);
  measure_depth(array, scene, resolved);
  return array;
}

Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved) {
  const Affine3f plane = similarity(resolved.of(array.node)) * array.node_from_plane;
  return {plane.linear * units_per_mm, plane.translation};
}

}  // namespace lippmann

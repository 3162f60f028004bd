// For infinite planes, 1 / depth is linear in the position in the window, so the extreme depths are at the window's corners.
#include "stage/seen_depth.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "lippmann/scene/timeline.hpp"
#include "scene/deform.hpp"
#include "stage/seen_bounds.hpp"

namespace lippmann {
namespace {

constexpr float kInfiniteDepth = std::numeric_limits<float>::infinity();

struct DepthReach {
  float near = -kInfiniteDepth, far = kInfiniteDepth;

  void add(float z) { near = std::max(near, z), far = std::min(far, z); }
  void add(const DepthReach& reach) { near = std::max(near, reach.near), far = std::min(far, reach.far); }
  void add(const Bounds3f& bounds) {
    if (!bounds.empty()) add(bounds.lower.z), add(bounds.upper.z);
  }
  bool contains(const Bounds3f& bounds) const { return bounds.lower.z >= far && bounds.upper.z <= near; }
};

HalfSpace normalized(Vec3f normal, float offset) {
  const float length = glm::length(normal);
  return {normal / length, offset / length};
}

ConvexRegion region_before(const EyeAtWindow& view) {
  const Vec3f eye = view.eye_mm;
  ConvexRegion region{{{0.0f, 0.0f, -1.0f}, eye.z}};
  for (const int axis : {0, 1})
    for (const float side : {1.0f, -1.0f}) {
      const float reach = 0.5f * view.window_mm[axis] - side * eye[axis];
      Vec3f normal(0.0f, 0.0f, -reach);
      normal[axis] = -side * eye.z;
      region.push_back(normalized(normal, (reach + side * eye[axis]) * eye.z));
    }
  return region;
}

class SeenMoment {
 public:
  SeenMoment(const Scene& scene, const ResolvedScene& resolved, const Affine3f& display_from_world, const EyeAtWindow& view)
      : scene_(scene),
        resolved_(resolved),
        display_from_world_(display_from_world),
        view_(view),
        region_(region_before(view)) {}

  void add(const Instance& instance, DepthReach& reach) const {
    if (instance.hidden_from_cameras) return;
    const Shape& shape = scene_.shapes[static_cast<std::size_t>(instance.shape)];
    if (const auto* planes = std::get_if<Planes>(&shape)) return add_planes(*planes, instance, reach);
    const Bounds3f box = finite_bounds(scene_, instance, resolved_, display_from_world_);
    if (box.empty() || reach.contains(box)) return;
    reach.add(seen_parts(scene_, instance, resolved_, display_from_world_, region_).bounds);
  }

 private:
  void add_planes(const Planes& planes, const Instance& instance, DepthReach& reach) const {
    const Affine3f display_from_node = display_from_world_ * resolved_.of(instance.node);
    const Mat3f of_normals = glm::transpose(glm::inverse(display_from_node.linear));
    for (const Plane& plane : planes)
      add_plane(transform_point(display_from_node, plane.point), of_normals * plane.normal, reach);
  }

  void add_plane(Vec3f point, Vec3f normal, DepthReach& reach) const {
    const float ahead = glm::dot(normal, point - view_.eye_mm);
    DepthReach seen;
    for (const float x : {-0.5f, 0.5f})
      for (const float y : {-0.5f, 0.5f}) {
        const Vec3f ray = Vec3f(Vec2f(x, y) * view_.window_mm, 0.0f) - view_.eye_mm;
        const float along = ahead / glm::dot(normal, ray);
        seen.add(along > 0.0f ? view_.eye_mm.z * (1.0f - along) : -kInfiniteDepth);
      }
    if (seen.near > -kInfiniteDepth) reach.add(seen);
  }

  const Scene& scene_;
  const ResolvedScene& resolved_;
  const Affine3f display_from_world_;
  const EyeAtWindow& view_;
  const ConvexRegion region_;
};

}  // namespace

std::optional<SeenDepth> seen_depth(const Scene& scene, const FittedArray& array, float units_per_mm, const EyeAtWindow& eye,
                                    const ThreadPool& pool) {
  const std::vector<bool> moves = moving_instances(scene);
  const bool eye_moves = array.node >= 0 && moving_nodes(scene)[static_cast<std::size_t>(array.node)];
  const auto reach_of = [&](int frame, DepthReach reach) {
    const ResolvedScene resolved = evaluate(scene, scene.timeline.time(frame));
    const SeenMoment moment(scene, resolved, inverse(world_from_display(array, units_per_mm, resolved)), eye);
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
      if (frame == 0 || eye_moves || moves[i]) moment.add(scene.instances[i], reach);
    return reach;
  };
  DepthReach all = reach_of(0, {});
  if (eye_moves || std::find(moves.begin(), moves.end(), true) != moves.end()) {
    std::vector<DepthReach> frames(static_cast<std::size_t>(std::max(1, scene.timeline.frame_count)), all);
    pool.for_each(frames.size(), [&](std::size_t frame) {
      if (frame > 0) frames[frame] = reach_of(static_cast<int>(frame), all);
    });
    for (const DepthReach& reach : frames) all.add(reach);
  }
  if (!(all.near > -kInfiniteDepth)) return std::nullopt;
  return SeenDepth{all.near, all.far};
}

}  // namespace lippmann

#include "stage/front_of_rays.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "core/printable.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/deform.hpp"
#include "stage/seen_bounds.hpp"
#include "stage/subject.hpp"

namespace lippmann {
namespace {

/// Walls that cover a smaller fraction of the frame do not matter. The frame is the rectangle of the display as the eye sees
/// it.
constexpr double kWallShare = 0.25;
/// Fraction of the way from the near clipping plane to the wall at which rays start.
constexpr float kBeforeWall = 0.999f;

constexpr std::size_t kNamed = 3;

class Foreground {
 public:
  Foreground(float near, float eye, Vec2f half) : near_(near), eye_(eye), half_(half) {
    region_ = view_region({0.0f, 0.0f, eye}, half / eye);
    region_.push_back({{0.0f, 0.0f, 1.0f}, -near});
  }

  void add(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& plane_from_world) {
    const Shape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
    walls_.push_back({0.0, eye_, instance.node});
    if (std::holds_alternative<Splats>(shape)) return;  // splats near the viewer are noise of the capture
    if (const auto* planes = std::get_if<Planes>(&shape))
      return add_planes(*planes, plane_from_world * resolved.of(instance.node));
    const Bounds3f box = finite_bounds(scene, instance, resolved, plane_from_world);
    if (box.empty() || box.upper.z <= near_ || box.lower.z >= eye_) return;
    visit_seen(scene, instance, resolved, plane_from_world, region_, [&](std::span<const Vec3f> polygon) { add(polygon); });
  }

  std::optional<FrontOfRays> front(const Scene& scene) const {
    if (!any_) return std::nullopt;
    const double enough = kWallShare * 4.0 * static_cast<double>(half_.x * half_.y);
    Walls alone{0.0, eye_}, together{0.0, eye_};
    for (const Walls& walls : walls_) {
      together.add(walls);
      if (walls.area >= enough) alone.add(walls);
    }
    const bool is_alone = alone.area > 0.0;
    const Walls& walls = is_alone ? alone : together;
    if (walls.area < enough) return FrontOfRays{eye_, {}};
    return FrontOfRays{near_ + kBeforeWall * (walls.nearest - near_), names(scene, is_alone ? enough : 0.0)};
  }

 private:
  std::string names(const Scene& scene, double enough) const {
    std::vector<std::string> names;
    for (const Walls& walls : walls_) {
      if (!(walls.area > 0.0) || walls.area < enough) continue;
      const std::string& name = walls.node < 0 ? std::string() : scene.nodes[static_cast<std::size_t>(walls.node)].name;
      const std::string shown = name.empty() ? "a part without a name" : fmt::format("'{}'", printable(name));
      if (std::find(names.begin(), names.end(), shown) == names.end()) names.push_back(shown);
    }
    if (names.size() > kNamed) names.resize(kNamed), names.emplace_back("others");
    return fmt::format("{}", fmt::join(names, ", "));
  }

  bool is_wall(Vec3f p, Vec3f normal) const {
    const float offset = -glm::dot(normal, p), of_near = normal.z * near_ + offset, of_eye = normal.z * eye_ + offset;
    return (of_near > 0.0f) != (of_eye > 0.0f);
  }

  void add(std::span<const Vec3f> polygon) {
    any_ = true;
    Vec3f normal(0.0f);
    for (std::size_t i = 2; i < polygon.size(); ++i) normal += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    if (!is_wall(polygon[0], normal)) return;
    double twice_area = 0.0;
    const auto seen = [&](Vec3f p) { return Vec2f(p) * (eye_ / std::max(eye_ - p.z, 1e-3f * eye_)); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2f a = seen(polygon[i]), b = seen(polygon[(i + 1) % polygon.size()]);
      twice_area += static_cast<double>(a.x * b.y - a.y * b.x);
      walls_.back().nearest = std::min(walls_.back().nearest, polygon[i].z);
    }
    walls_.back().area += 0.5 * std::abs(twice_area);
  }

  void add_planes(const Planes& planes, const Affine3f& plane_from_node) {
    const Mat3f of_normals = glm::transpose(glm::inverse(plane_from_node.linear));
    for (const Plane& plane : planes) add_plane(transform_point(plane_from_node, plane.point), of_normals * plane.normal);
  }

  /// Takes an infinite plane into account if it is visible in a corner of the frame, or if it separates the near clipping plane
  /// from the eye.
  void add_plane(Vec3f p, Vec3f normal) {
    const float ahead = glm::dot(normal, p - Vec3f(0.0f, 0.0f, eye_));
    for (const float x : {-half_.x, half_.x})
      for (const float y : {-half_.y, half_.y}) {
        const float along = ahead / glm::dot(normal, Vec3f(x, y, -eye_));
        any_ |= along > 0.0f && eye_ * (1.0f - along) > near_;
      }
    if (!is_wall(p, normal)) return;
    any_ = true;
    walls_.back().add({4.0 * static_cast<double>(half_.x * half_.y), glm::dot(normal, p) / normal.z});
  }

  struct Walls {
    double area;  ///< projected from the eye to the plane z = 0
    float nearest;
    int node = -1;

    void add(const Walls& other) { area += other.area, nearest = std::min(nearest, other.nearest); }
  };

  float near_, eye_;
  Vec2f half_;
  ConvexRegion region_;
  bool any_ = false;
  std::vector<Walls> walls_;
};

}  // namespace

FrontOfRays front_of_rays(const Scene& scene, const FittedArray& array, float aspect, float eye) {
  const float viewer = array.viewing_distance, near = viewer - array.near_distance;
  const float start = std::isfinite(eye) && eye > 1.0001f * viewer ? eye : viewer;
  if (!(start > near + 1e-4f * viewer)) return {viewer, {}};
  const Vec2f half = 0.5f * array.plane_height * Vec2f(aspect, 1.0f);
  const std::vector<bool> moves = moving_instances(scene), nodes_move = moving_nodes(scene);
  const auto any = [](const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); };
  std::optional<FrontOfRays> front;
  for (const int frame : sampled_frames(scene.timeline)) {
    if (frame > 0 && !any(moves) && !any(nodes_move)) break;
    const ResolvedScene resolved = evaluate(scene, scene.timeline.time(frame));
    const Affine3f plane_from_world = inverse(world_from_display(array, 1.0f, resolved));
    Foreground foreground(near, start, half);
    for (const Instance& instance : scene.instances)
      if (!instance.hidden_from_cameras) foreground.add(scene, instance, resolved, plane_from_world);
    const std::optional<FrontOfRays> of_frame = foreground.front(scene);
    if (of_frame && (!front || of_frame->z < front->z)) front = of_frame;
  }
  if (!front) return {viewer, {}};
  if (!front->cut.empty())
    front->cut =
        fmt::format("Rays begin {:.4g} units in front of the plane, because walls would hide the scene from the viewer: {}.",
                    front->z, front->cut);
  return *front;
}

}  // namespace lippmann

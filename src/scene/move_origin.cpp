// A node may have an anchor: the point, in the node's coordinates, that becomes the new origin of these coordinates. Let a_n be
// the anchor of a node and a_p the anchor of its parent. For root nodes, a_p is the new origin of the scene. Let T(v) be the
// translation by v.
// 1. The node's transform L becomes T(-a_p) L T(a_n).
// 2. Shapes at the node move by -a_n.
//
// Nodes near the new origin keep their coordinates: a_n = 0. For other nodes, such as a root at the old origin, the anchor is
// the new origin of the scene.
#include "scene/move_origin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <variant>

#include "lippmann/scene/load.hpp"
#include "lippmann/scene/origin.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {
namespace {

// Largest allowed distance of a scene from its origin, in diagonals of the scene; see origin.hpp.
constexpr double kFarthest = 64.0;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Affine3d affine_of(const Transform& t) {
  const glm::dmat3 r = glm::mat3_cast(glm::normalize(glm::dquat(t.rotation)));
  const Vec3d s(t.scale);
  return {{s.x * r[0], s.y * r[1], s.z * r[2]}, Vec3d(t.translation)};
}

Affine3d affine_of(const Node& node) {
  if (node.matrix) return {glm::dmat3(node.matrix->linear), Vec3d(node.matrix->translation)};
  return affine_of(node.local);
}

template <class T>
T first_value(const Channel<T>& channel, const T& if_not_animated) {
  if (channel.times.empty()) return if_not_animated;
  return channel.values[channel.interpolation == Interpolation::kCubicSpline ? 1 : 0];
}

Vec3d apply(const Affine3d& a, Vec3d p) { return a.linear * p + a.translation; }
Affine3d operator*(const Affine3d& a, const Affine3d& b) { return {a.linear * b.linear, apply(a, b.translation)}; }

void move(Vec3f& p, Vec3d by) { p = Vec3f(Vec3d(p) - by); }

struct MoveShape {
  Vec3d by;
  void operator()(Mesh& mesh) const {
    for (Vec3f& p : mesh.positions) move(p, by);
  }
  void operator()(Spheres& spheres) const {
    for (Sphere& s : spheres) move(s.center, by);
  }
  void operator()(Cylinders& cylinders) const {
    for (Cylinder& c : cylinders) move(c.base, by), move(c.apex, by);
  }
  void operator()(Planes& planes) const {
    for (Plane& p : planes) move(p.point, by);
  }
  void operator()(Rings& rings) const {
    for (Ring& r : rings) move(r.center, by);
  }
  void operator()(Boxes& boxes) const {
    for (Box& b : boxes) move(b.lower, by), move(b.upper, by);
  }
  void operator()(Splats& splats) const {
    for (Vec3f& c : splats.centers) move(c, by);
  }
};

class OriginMover {
 public:
  OriginMover(Scene& scene, Vec3d origin, const std::vector<Affine3d>& parent_from_node)
      : scene_(scene), origin_(origin), local_(parent_from_node) {
    for (std::size_t i = local_.size(); i < scene.nodes.size(); ++i) local_.push_back(affine_of(scene.nodes[i]));
    // The origin moves only if its distance exceeds kFarthest diagonals, so a diagonal is at most length(origin) / kFarthest.
    // The factor 2 leaves room for animated motion.
    reach_ = 2.0 * glm::length(origin) / kFarthest;
  }

  void run() {
    find_anchors();
    move_instances();
    move_nodes();
    attach_to_old_origin();
    scene_.origin += origin_;
  }

 private:
  Vec3d anchor(int node) const { return node < 0 ? origin_ : anchors_[at(node)]; }

  /// Returns for each node whether it must keep its origin: nodes with animated rotation or scale, and nodes of cameras, lights
  /// and the display.
  std::vector<bool> nodes_without_anchor() const {
    std::vector<bool> without(scene_.nodes.size(), false);
    const auto exclude = [&](int node) {
      if (node >= 0) without[at(node)] = true;
    };
    for (const Camera& camera : scene_.cameras) exclude(camera.node);
    for (const Light& light : scene_.lights) exclude(light.node);
    if (scene_.display) exclude(scene_.display->node);
    for (const NodeAnimation& a : scene_.timeline.animations)
      if (!a.rotation.times.empty() || !a.scale.times.empty()) exclude(a.node);
    return without;
  }

  /// Returns world_from_node for all nodes at the first keyframe of the animation.
  std::vector<Affine3d> world_from_nodes() const {
    std::vector<Affine3d> world = local_;
    for (const NodeAnimation& a : scene_.timeline.animations) {
      const Node& node = scene_.nodes[at(a.node)];
      if (node.matrix) continue;
      world[at(a.node)] =
          affine_of(Transform{first_value(a.translation, node.local.translation), first_value(a.rotation, node.local.rotation),
                              first_value(a.scale, node.local.scale)});
    }
    for (std::size_t i = 0; i < world.size(); ++i)
      if (const int parent = scene_.nodes[i].parent; parent >= 0) world[i] = world[at(parent)] * world[i];
    return world;
  }

  void find_anchors() {
    const std::vector<bool> without = nodes_without_anchor();
    const std::vector<Affine3d> world = world_from_nodes();
    anchors_.assign(scene_.nodes.size(), Vec3d(0.0));
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      const Vec3d away = origin_ - world[i].translation;
      if (without[i] || glm::length(away) <= reach_) continue;
      const Vec3d anchor = glm::inverse(world[i].linear) * away;
      if (std::isfinite(anchor.x + anchor.y + anchor.z)) anchors_[i] = anchor;
    }
  }

  void move_nodes() {
    std::vector<Vec3d> by(scene_.nodes.size());
    for (std::size_t i = 0; i < by.size(); ++i) {
      Node& node = scene_.nodes[i];
      by[i] = local_[i].linear * anchors_[i] - anchor(node.parent);
      if (by[i] == Vec3d(0.0)) continue;
      (node.matrix ? node.matrix->translation : node.local.translation) = Vec3f(local_[i].translation + by[i]);
    }
    for (NodeAnimation& a : scene_.timeline.animations) {
      const bool is_cubic = a.translation.interpolation == Interpolation::kCubicSpline;
      for (std::size_t i = is_cubic ? 1 : 0; i < a.translation.values.size(); i += is_cubic ? 3 : 1)
        move(a.translation.values[i], -by[at(a.node)]);
    }
  }

  /// A shape whose instances move by different vectors is copied.
  void move_instances() {
    std::map<int, Vec3d> of_skin;
    std::map<std::pair<int, std::array<double, 3>>, int> moved;
    std::map<int, int> users;
    std::vector<std::pair<int, Vec3d>> moves;
    for (Instance& instance : scene_.instances) {
      const Vec3d by = instance.skin < 0 ? anchor(instance.node) : middle_of_skinned(instance, of_skin);
      const auto [entry, is_new] = moved.try_emplace({instance.shape, {by.x, by.y, by.z}}, instance.shape);
      if (is_new && users[instance.shape]++ > 0) {
        entry->second = static_cast<int>(scene_.shapes.size());
        scene_.shapes.push_back(Shape(scene_.shapes[at(instance.shape)]));
      }
      if (is_new) moves.emplace_back(entry->second, by);
      instance.shape = entry->second;
    }
    for (const auto& [shape, by] : moves)
      if (by != Vec3d(0.0)) std::visit(MoveShape{by}, scene_.shapes[at(shape)]);
    for (std::size_t s = 0; s < scene_.skins.size(); ++s) move_skin(scene_.skins[s], of_skin[static_cast<int>(s)]);
  }

  /// Returns the new origin for the meshes of a skin: the middle of the mesh if the mesh is far from its origin, otherwise
  /// zero. All meshes of a skin get the same new origin.
  Vec3d middle_of_skinned(const Instance& instance, std::map<int, Vec3d>& of_skin) const {
    const auto [known, is_new] = of_skin.try_emplace(instance.skin, Vec3d(0.0));
    if (!is_new) return known->second;
    Bounds3f bounds;
    for (const Vec3f& p : std::get<Mesh>(scene_.shapes[at(instance.shape)]).positions) bounds.add(p);
    if (!bounds.empty() && glm::length(bounds.center()) > static_cast<float>(kFarthest) * glm::length(bounds.size()))
      known->second = Vec3d(bounds.center());
    return known->second;
  }

  void move_skin(Skin& skin, Vec3d mesh_by) const {
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      Affine3f& joint_from_mesh = skin.joint_from_mesh[j];
      const Affine3d exact{glm::dmat3(joint_from_mesh.linear), Vec3d(joint_from_mesh.translation)};
      joint_from_mesh.translation = Vec3f(apply(exact, mesh_by) - anchor(skin.joints[j]));
    }
  }

  void attach_to_old_origin() {
    int node = -1;
    const auto place = [&](int& of) {
      if (of >= 0) return;
      if (node < 0) {
        node = static_cast<int>(scene_.nodes.size());
        Node& old_origin = scene_.nodes.emplace_back();
        old_origin.name = "origin";
        old_origin.local.translation = Vec3f(-origin_);
      }
      of = node;
    };
    for (Camera& camera : scene_.cameras) place(camera.node);
    for (Light& light : scene_.lights) place(light.node);
    if (scene_.display) place(scene_.display->node);
  }

  Scene& scene_;
  Vec3d origin_;
  std::vector<Affine3d> local_;
  double reach_;  ///< nodes farther from the new origin than this get an anchor
  std::vector<Vec3d> anchors_;
};

bool has_projections(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
    const auto* surface = std::get_if<PhongSurface>(&material.surface);
    return surface && surface->projection;
  });
}

Vec3d middle_of(const Bounds3f& bounds) { return 0.5 * (Vec3d(bounds.lower) + Vec3d(bounds.upper)); }
double size_of(const Bounds3f& bounds) { return glm::length(Vec3d(bounds.upper) - Vec3d(bounds.lower)); }

bool is_distant(const Bounds3f& bounds) {
  if (bounds.empty()) return false;
  const double away = glm::length(middle_of(bounds)), size = size_of(bounds);
  return std::isfinite(away) && std::isfinite(size) && away > kFarthest * size;
}

/// Returns the middle of the bounds, rounded to a multiple of a power of two near the size of the bounds. Subtracting this
/// point from positions is then exact.
Vec3d rounded_middle(const Bounds3f& bounds) {
  const Vec3d middle = middle_of(bounds);
  const double step = std::exp2(std::floor(std::log2(std::max(size_of(bounds), glm::length(middle) * 0x1p-22))));
  return step * glm::round(middle / step);
}

}  // namespace

std::optional<Vec3d> distant_origin(const Scene& scene) {
  const ResolvedScene rest = evaluate(scene, scene.timeline.time(0));
  Bounds3f all, distant, near;
  for (const Instance& instance : scene.instances) {
    const Bounds3f bounds = finite_bounds(scene, instance, rest);
    if (bounds.empty()) continue;
    all.add(bounds);
    (is_distant(bounds) ? distant : near).add(bounds);
  }
  if (is_distant(all)) return rounded_middle(all);
  if (is_distant(distant) && (near.empty() || size_of(distant) > size_of(near))) return rounded_middle(distant);
  return std::nullopt;
}

void move_origin(Scene& scene, Vec3d origin, const std::vector<Affine3d>& parent_from_node) {
  OriginMover(scene, origin, parent_from_node).run();
}

void move_near_origin(Scene& scene) {
  validate(scene, "scene");
  if (has_projections(scene)) return;
  if (const std::optional<Vec3d> origin = distant_origin(scene)) move_origin(scene, *origin);
}

}  // namespace lippmann

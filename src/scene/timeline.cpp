// Based on: Khronos Group, "glTF 2.0 Specification", 2021, appendix C "Animation sampler interpolation modes". The modes are:
// - step,
// - linear; for quaternions spherical along the shorter arc,
// - cubic Hermite spline. Tangents are per second and are multiplied by the length of the interval. Quaternions are normalised
//   after interpolation.
//
// The bounds of transformed balls and discs are exact for every affine map. Let l be row i of the map's linear part. A ball of
// radius r extends r |l| from its centre along axis i. A disc of radius r with unit normal n extends r |l - (l . n) n| from its
// centre along axis i.
#include "lippmann/scene/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "lippmann/core/error.hpp"
#include "scene/deform.hpp"
#include "scene/splats.hpp"

namespace lippmann {
namespace {

float interpolate(float a, float b, float u) { return (1.0f - u) * a + u * b; }
Vec3f interpolate(Vec3f a, Vec3f b, float u) { return (1.0f - u) * a + u * b; }

Quatf interpolate(Quatf a, Quatf b, float u) {
  float cosine = glm::dot(a, b);
  if (cosine < 0.0f) b = -b, cosine = -cosine;
  // Below 0.03 degrees, linear interpolation is exact to the last bits, while the spherical formula divides by a small sine.
  if (cosine > 1.0f - 1e-7f) return glm::normalize((1.0f - u) * a + u * b);
  const float angle = std::acos(cosine);
  return glm::normalize((std::sin((1.0f - u) * angle) * a + std::sin(u * angle) * b) / std::sin(angle));
}

float unit_if_rotation(float x) { return x; }
Vec3f unit_if_rotation(Vec3f v) { return v; }
Quatf unit_if_rotation(Quatf q) { return glm::normalize(q); }

/// Selects one of the `count` values that a channel stores per key. Only morph weights have several values per key.
struct Component {
  std::size_t index = 0, count = 1;
};

template <class T>
const T& value_at(const Channel<T>& channel, std::size_t place, Component c) {
  return channel.values[place * c.count + c.index];
}

template <class T>
T value_of_key(const Channel<T>& channel, std::size_t key, Component c) {
  const std::size_t place = channel.interpolation == Interpolation::kCubicSpline ? 3 * key + 1 : key;
  return unit_if_rotation(value_at(channel, place, c));
}

template <class T>
T cubic(const Channel<T>& channel, std::size_t key, Component c, float u, float seconds) {
  const float u2 = u * u, u3 = u2 * u;
  const T from = value_at(channel, 3 * key + 1, c), out_tangent = value_at(channel, 3 * key + 2, c);
  const T in_tangent = value_at(channel, 3 * key + 3, c), to = value_at(channel, 3 * key + 4, c);
  return unit_if_rotation((2.0f * u3 - 3.0f * u2 + 1.0f) * from + (seconds * (u3 - 2.0f * u2 + u)) * out_tangent +
                          (3.0f * u2 - 2.0f * u3) * to + (seconds * (u3 - u2)) * in_tangent);
}

template <class T>
T evaluate(const Channel<T>& channel, double time, T if_not_animated, Component c = {}) {
  const std::vector<double>& times = channel.times;
  if (times.empty()) return if_not_animated;
  if (!(time > times.front())) return value_of_key(channel, 0, c);
  if (time >= times.back()) return value_of_key(channel, times.size() - 1, c);
  const std::size_t key = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin()) - 1;
  if (channel.interpolation == Interpolation::kStep) return value_of_key(channel, key, c);
  const double seconds = times[key + 1] - times[key];
  const float u = static_cast<float>((time - times[key]) / seconds);
  if (channel.interpolation == Interpolation::kCubicSpline) return cubic(channel, key, c, u, static_cast<float>(seconds));
  return interpolate(value_of_key(channel, key, c), value_of_key(channel, key + 1, c), u);
}

template <class T>
bool changes(const Channel<T>& channel, Component c = {}) {
  const std::size_t keys = channel.times.size();
  if (keys < 2) return false;
  const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
  const std::size_t per_key = cubic ? 3 : 1, place = cubic ? 1 : 0;
  const T first = value_at(channel, place, c), still = first - first;
  for (std::size_t key = 0; key < keys; ++key) {
    if (value_at(channel, per_key * key + place, c) != first) return true;
    if (cubic && (value_at(channel, 3 * key, c) != still || value_at(channel, 3 * key + 2, c) != still)) return true;
  }
  return false;
}

Affine3f affine(const Transform& t) {
  const Mat3f r = glm::mat3_cast(glm::normalize(t.rotation));
  return {{t.scale.x * r[0], t.scale.y * r[1], t.scale.z * r[2]}, t.translation};
}

void add_around(Bounds3f& bounds, Vec3f center, Vec3f reach) {
  bounds.add(center - reach);
  bounds.add(center + reach);
}

Vec3f disc_reach(const Affine3f& frame_from_node, Vec3f normal, float radius) {
  const Mat3f rows = glm::transpose(frame_from_node.linear);
  Vec3f reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = radius * glm::length(rows[axis] - glm::dot(rows[axis], normal) * normal);
  return reach;
}

/// Calls visit(vertex) once for each vertex that a triangle uses. Files may contain unused vertices far away.
template <class Visit>
void visit_used_vertices(const Mesh& mesh, const Visit& visit) {
  std::vector<bool> is_used(mesh.positions.size(), false);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  for (std::size_t i = 0; i < is_used.size(); ++i)
    if (is_used[i]) visit(i);
}

void add_shape(Bounds3f& bounds, const Affine3f& a, const Mesh& mesh) {
  visit_used_vertices(mesh, [&](std::size_t i) { bounds.add(transform_point(a, mesh.positions[i])); });
}

void add_posed(Bounds3f& bounds, const Affine3f& frame_from_world, const Scene& scene, const Instance& instance,
               const ResolvedScene& resolved) {
  const MeshPose pose(scene, instance, resolved);
  visit_used_vertices(std::get<Mesh>(scene.shapes[static_cast<std::size_t>(instance.shape)]),
                      [&](std::size_t i) { bounds.add(transform_point(frame_from_world, pose.position(i))); });
}

void add_shape(Bounds3f& bounds, const Affine3f& a, const Spheres& spheres) {
  const Mat3f rows = glm::transpose(a.linear);
  const Vec3f unit_reach(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  for (const Sphere& s : spheres) add_around(bounds, transform_point(a, s.center), s.radius * unit_reach);
}

void add_shape(Bounds3f& bounds, const Affine3f& a, const Cylinders& cylinders) {
  for (const Cylinder& c : cylinders) {
    const Vec3f reach = disc_reach(a, glm::normalize(c.apex - c.base), c.radius);
    add_around(bounds, transform_point(a, c.base), reach);
    add_around(bounds, transform_point(a, c.apex), reach);
  }
}

void add_shape(Bounds3f&, const Affine3f&, const Planes&) {}

void add_shape(Bounds3f& bounds, const Affine3f& a, const Rings& rings) {
  for (const Ring& r : rings) add_around(bounds, transform_point(a, r.center), disc_reach(a, r.normal, r.outer_radius));
}

void add_shape(Bounds3f& bounds, const Affine3f& a, const Boxes& boxes) {
  for (const Box& b : boxes) bounds.add(transform_bounds(a, {b.lower, b.upper}));
}

void add_shape(Bounds3f& bounds, const Affine3f& a, const Splats& splats) { bounds.add(bulk_bounds(splats, a)); }

void require_nodes(const Scene& scene) {
  const int count = static_cast<int>(scene.nodes.size());
  for (int i = 0; i < count; ++i)
    if (const int parent = scene.nodes[static_cast<std::size_t>(i)].parent; parent < -1 || parent >= i)
      throw Error("scene", fmt::format("node {} has the parent {}", i, parent),
                  "the number of an earlier node, or -1 for no parent");
  for (const NodeAnimation& a : scene.timeline.animations)
    if (a.node < 0 || a.node >= count)
      throw Error("scene", fmt::format("an animation moves node {}, but the number of nodes is {}", a.node, count),
                  "a number from 0, below the number of nodes");
}

std::vector<std::vector<float>> evaluate_weights(const Scene& scene, double time) {
  std::vector<std::vector<float>> weights;
  const auto has_weights = [](const Node& node) { return !node.morph_weights.empty(); };
  if (std::none_of(scene.nodes.begin(), scene.nodes.end(), has_weights)) return weights;
  for (const Node& node : scene.nodes) weights.push_back(node.morph_weights);
  for (const NodeAnimation& a : scene.timeline.animations) {
    std::vector<float>& of_node = weights[static_cast<std::size_t>(a.node)];
    for (std::size_t i = 0; i < of_node.size(); ++i)
      of_node[i] = evaluate(a.morph_weights, time, of_node[i], {i, of_node.size()});
  }
  return weights;
}

}  // namespace

ResolvedScene evaluate(const Scene& scene, double time) {
  require_nodes(scene);
  std::vector<const NodeAnimation*> animation_of(scene.nodes.size(), nullptr);
  for (const NodeAnimation& a : scene.timeline.animations) animation_of[static_cast<std::size_t>(a.node)] = &a;

  ResolvedScene resolved;
  resolved.morph_weights = evaluate_weights(scene, time);
  resolved.world_from_node.reserve(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    Transform local = node.local;
    if (const NodeAnimation* a = animation_of[i]) {
      local.translation = evaluate(a->translation, time, local.translation);
      local.rotation = evaluate(a->rotation, time, local.rotation);
      local.scale = evaluate(a->scale, time, local.scale);
    }
    const Affine3f parent_from_node = node.matrix ? *node.matrix : affine(local);
    resolved.world_from_node.push_back(node.parent < 0 ? parent_from_node : resolved.of(node.parent) * parent_from_node);
  }
  return resolved;
}

bool keys_fall_on_frames(const Timeline& timeline, double frames_per_second) {
  // Tolerance in frames. Times rounded to four decimals are off by up to 0.003 frames at 60 frames per second.
  constexpr double kNearFrame = 0.02;
  const auto on_frames = [&](const std::vector<double>& times) {
    return std::all_of(times.begin(), times.end(), [&](double time) {
      const double frame = time * frames_per_second;
      return std::abs(frame - std::round(frame)) <= kNearFrame;
    });
  };
  return std::all_of(timeline.animations.begin(), timeline.animations.end(), [&](const NodeAnimation& a) {
    return on_frames(a.translation.times) && on_frames(a.rotation.times) && on_frames(a.scale.times) &&
           on_frames(a.morph_weights.times);
  });
}

std::vector<bool> moving_nodes(const Scene& scene) {
  std::vector<bool> moves(scene.nodes.size(), false);
  for (const NodeAnimation& a : scene.timeline.animations) {
    const std::size_t node = static_cast<std::size_t>(a.node);
    if (!scene.nodes[node].matrix) moves[node] = changes(a.translation) || changes(a.rotation) || changes(a.scale);
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const int parent = scene.nodes[i].parent;
    if (parent >= 0 && moves[static_cast<std::size_t>(parent)]) moves[i] = true;
  }
  return moves;
}

std::vector<bool> morphing_nodes(const Scene& scene) {
  std::vector<bool> changing(scene.nodes.size(), false);
  for (const NodeAnimation& a : scene.timeline.animations) {
    const auto node = static_cast<std::size_t>(a.node);
    const std::size_t count = scene.nodes[node].morph_weights.size();
    for (std::size_t i = 0; i < count && !changing[node]; ++i) changing[node] = changes(a.morph_weights, {i, count});
  }
  return changing;
}

Bounds3f finite_bounds(const Scene& scene, const ResolvedScene& resolved, const Affine3f& frame_from_world) {
  Bounds3f bounds;
  for (const Instance& instance : scene.instances) bounds.add(finite_bounds(scene, instance, resolved, frame_from_world));
  return bounds;
}

Bounds3f finite_bounds(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                       const Affine3f& frame_from_world) {
  Bounds3f bounds;
  if (is_posed(scene, instance)) {
    add_posed(bounds, frame_from_world, scene, instance, resolved);
    return bounds;
  }
  const Affine3f frame_from_node = frame_from_world * resolved.of(instance.node);
  std::visit([&](const auto& shape) { add_shape(bounds, frame_from_node, shape); },
             scene.shapes[static_cast<std::size_t>(instance.shape)]);
  return bounds;
}

}  // namespace lippmann

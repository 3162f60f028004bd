// Based on: Khronos Group, "glTF 2.0 Specification", 2021, appendix C "Animation sampler interpolation modes": step, linear
// (quaternions: spherical along the shorter arc) and cubic Hermite spline, whose tangents are per second and are therefore
// multiplied by the length of the interval. Cubic quaternions are normalised after interpolation.
//
// Bounds are exact for every affine map: with L the linear part and l its i-th row, a ball of radius r reaches r |l| to either
// side of its centre along world axis i, and a disc with unit normal n reaches r |l - (l . n) n|.
#include "scene/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

namespace lippmann {
namespace {

// ---- Channels -------------------------------------------------------------------------------------------------------

Vec3f interpolate(Vec3f a, Vec3f b, float u) { return (1.0f - u) * a + u * b; }

Quatf interpolate(Quatf a, Quatf b, float u) {
  float cosine = glm::dot(a, b);
  if (cosine < 0.0f) b = -b, cosine = -cosine;
  // Below 0.03 degrees the chord and the arc agree to the last bits, while the sine in the formula loses them.
  if (cosine > 1.0f - 1e-7f) return glm::normalize((1.0f - u) * a + u * b);
  const float angle = std::acos(cosine);
  return glm::normalize((std::sin((1.0f - u) * angle) * a + std::sin(u * angle) * b) / std::sin(angle));
}

Vec3f unit_if_rotation(Vec3f v) { return v; }
Quatf unit_if_rotation(Quatf q) { return glm::normalize(q); }

template <class T>
T value_of_key(const Channel<T>& channel, std::size_t key) {
  const std::size_t index = channel.interpolation == Interpolation::kCubicSpline ? 3 * key + 1 : key;
  return unit_if_rotation(channel.values[index]);
}

template <class T>
T cubic(const Channel<T>& channel, std::size_t key, float u, float seconds) {
  const float u2 = u * u, u3 = u2 * u;
  const T from = channel.values[3 * key + 1], out_tangent = channel.values[3 * key + 2];
  const T in_tangent = channel.values[3 * key + 3], to = channel.values[3 * key + 4];
  return unit_if_rotation((2.0f * u3 - 3.0f * u2 + 1.0f) * from + (seconds * (u3 - 2.0f * u2 + u)) * out_tangent +
                          (3.0f * u2 - 2.0f * u3) * to + (seconds * (u3 - u2)) * in_tangent);
}

template <class T>
T evaluate(const Channel<T>& channel, double time, T if_not_animated) {
  const std::vector<double>& times = channel.times;
  if (times.empty()) return if_not_animated;
  if (!(time > times.front())) return value_of_key(channel, 0);
  if (time >= times.back()) return value_of_key(channel, times.size() - 1);
  const std::size_t key = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin()) - 1;
  if (channel.interpolation == Interpolation::kStep) return value_of_key(channel, key);
  const double seconds = times[key + 1] - times[key];
  const float u = static_cast<float>((time - times[key]) / seconds);
  if (channel.interpolation == Interpolation::kCubicSpline) return cubic(channel, key, u, static_cast<float>(seconds));
  return interpolate(value_of_key(channel, key), value_of_key(channel, key + 1), u);
}

template <class T>
bool changes(const Channel<T>& channel) {
  if (channel.times.size() < 2) return false;
  const auto differs = [&](const T& v) { return v != channel.values.front(); };
  if (channel.interpolation != Interpolation::kCubicSpline)
    return std::any_of(channel.values.begin(), channel.values.end(), differs);
  const T still = channel.values[0] - channel.values[0];
  for (std::size_t key = 0; key < channel.times.size(); ++key)
    if (channel.values[3 * key] != still || channel.values[3 * key + 1] != channel.values[1] ||
        channel.values[3 * key + 2] != still)
      return true;
  return false;
}

// ---- Nodes ----------------------------------------------------------------------------------------------------------

Affine3f affine(const Transform& t) {
  const Mat3f r = glm::mat3_cast(glm::normalize(t.rotation));
  return {{t.scale.x * r[0], t.scale.y * r[1], t.scale.z * r[2]}, t.translation};
}

// ---- Bounds ---------------------------------------------------------------------------------------------------------

void add_around(Bounds3f& bounds, Vec3f center, Vec3f reach) {
  bounds.add(center - reach);
  bounds.add(center + reach);
}

/// How far a disc reaches from its centre along each axis of the frame.
Vec3f disc_reach(const Affine3f& frame_from_node, Vec3f normal, float radius) {
  const Mat3f rows = glm::transpose(frame_from_node.linear);
  Vec3f reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = radius * glm::length(rows[axis] - glm::dot(rows[axis], normal) * normal);
  return reach;
}

void add_shape(Bounds3f& bounds, const Affine3f& a, const Mesh& mesh) {
  for (const Vec3f& p : mesh.positions) bounds.add(transform_point(a, p));
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

}  // namespace

ResolvedScene evaluate(const Scene& scene, double time) {
  std::vector<const NodeAnimation*> animation_of(scene.nodes.size(), nullptr);
  for (const NodeAnimation& a : scene.timeline.animations) animation_of[static_cast<std::size_t>(a.node)] = &a;

  ResolvedScene resolved;
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

Bounds3f finite_bounds(const Scene& scene, const ResolvedScene& resolved, const Affine3f& frame_from_world) {
  Bounds3f bounds;
  for (const Instance& instance : scene.instances) {
    const Affine3f frame_from_node = frame_from_world * resolved.of(instance.node);
    std::visit([&](const auto& shape) { add_shape(bounds, frame_from_node, shape); },
               scene.shapes[static_cast<std::size_t>(instance.shape)]);
  }
  return bounds;
}

}  // namespace lippmann

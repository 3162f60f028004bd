#include "device/primitives.hpp"

#include "lippmann/scene/scene.hpp"

namespace lippmann {
namespace {

struct BoxFrame {
  Vec3f center;
  Mat3f half_axes;
};

BoxFrame frame_of(const WorldBox& b) {
  const Affine3f box_from_world{Mat3f(b.m[0], b.m[1], b.m[2], b.m[3], b.m[4], b.m[5], b.m[6], b.m[7], b.m[8]),
                                {b.t[0], b.t[1], b.t[2]}};
  const Affine3f world_from_box = inverse(box_from_world);
  return {world_from_box.translation, world_from_box.linear};
}

int largest_component(Vec3f v) {
  const Vec3f a = glm::abs(v);
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

}  // namespace

WorldSphere to_world(const Affine3f& world_from_local, const Sphere& sphere) {
  const Vec3f c = transform_point(world_from_local, sphere.center);
  return {c.x, c.y, c.z, sphere.radius * uniform_scale(world_from_local)};
}

WorldCylinder to_world(const Affine3f& world_from_local, const Cylinder& cylinder) {
  const Vec3f base = transform_point(world_from_local, cylinder.base);
  const Vec3f along = transform_point(world_from_local, cylinder.apex) - base;
  const float length = glm::length(along);
  const Vec3f axis = length > 0.0f ? along / length : Vec3f(0, 0, 1);
  return {base.x, base.y, base.z, axis.x, axis.y, axis.z, length, cylinder.radius * uniform_scale(world_from_local)};
}

WorldPlane to_world(const Affine3f& world_from_local, const Plane& plane) {
  const Vec3f n = glm::normalize(transform_normal(world_from_local, plane.normal));
  return {n.x, n.y, n.z, glm::dot(n, transform_point(world_from_local, plane.point))};
}

WorldRing to_world(const Affine3f& world_from_local, const Ring& ring) {
  const Vec3f c = transform_point(world_from_local, ring.center);
  const Vec3f n = glm::normalize(transform_normal(world_from_local, ring.normal));
  const float scale = uniform_scale(world_from_local);
  return {c.x, c.y, c.z, n.x, n.y, n.z, ring.inner_radius * scale, ring.outer_radius * scale};
}

WorldBox to_world(const Affine3f& world_from_local, const Box& box) {
  const Vec3f half = 0.5f * (box.upper - box.lower);
  const Affine3f local_from_box{Mat3f(half.x, 0, 0, 0, half.y, 0, 0, 0, half.z), 0.5f * (box.upper + box.lower)};
  const Affine3f world_from_box = world_from_local * local_from_box;
  const Affine3f box_from_world = inverse(world_from_box);
  const Vec3f& center = world_from_box.translation;
  const Mat3f& m = box_from_world.linear;
  return {{m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]},
          {box_from_world.translation.x, box_from_world.translation.y, box_from_world.translation.z},
          {center.x, center.y, center.z}};
}

Bounds3f bounds(const WorldSphere& s) {
  return {{s.x - s.radius, s.y - s.radius, s.z - s.radius}, {s.x + s.radius, s.y + s.radius, s.z + s.radius}};
}

Bounds3f bounds(const WorldCylinder& c) {
  const Vec3f base(c.x, c.y, c.z), axis(c.ax, c.ay, c.az), apex = base + c.length * axis;
  const Vec3f reach = c.radius * glm::sqrt(glm::max(Vec3f(0.0f), Vec3f(1.0f) - axis * axis));
  return {glm::min(base, apex) - reach, glm::max(base, apex) + reach};
}

Bounds3f bounds(const WorldRing& g) {
  const Vec3f center(g.x, g.y, g.z), n(g.nx, g.ny, g.nz);
  const Vec3f reach = g.outer * glm::sqrt(glm::max(Vec3f(0.0f), Vec3f(1.0f) - n * n));
  return {center - reach, center + reach};
}

Bounds3f bounds(const WorldBox& b) {
  const BoxFrame frame = frame_of(b);
  const Vec3f reach = glm::abs(frame.half_axes[0]) + glm::abs(frame.half_axes[1]) + glm::abs(frame.half_axes[2]);
  return {frame.center - reach, frame.center + reach};
}

Vec3f normal_at(const WorldBox& b, Vec3f p) {
  const Vec3f q(b.m[0] * p.x + b.m[3] * p.y + b.m[6] * p.z + b.t[0], b.m[1] * p.x + b.m[4] * p.y + b.m[7] * p.z + b.t[1],
                b.m[2] * p.x + b.m[5] * p.y + b.m[8] * p.z + b.t[2]);
  const int axis = largest_component(q);
  // A face's normal is a column of the inverse transpose of world_from_box. This column is a row of box_from_world.
  const Vec3f n(b.m[axis], b.m[axis + 3], b.m[axis + 6]);
  return q[axis] < 0.0f ? -n : n;
}

Vec3f tachyon_box_normal(const WorldBox& b, Vec3f p) {
  const Vec3f q = p - Vec3f(b.center[0], b.center[1], b.center[2]);
  Vec3f n(0.0f);
  const int axis = largest_component(q);
  n[axis] = q[axis] < 0.0f ? -1.0f : 1.0f;
  return n;
}

}  // namespace lippmann

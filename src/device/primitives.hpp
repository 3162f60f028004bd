// Intersections of rays with analytic shapes in world space: spheres, open cylinders, rings, boxes and planes.
//
// Each `distance(primitive, ray)` returns the parameter t of the nearest intersection with t_near < t < t_far, or +infinity.
// The functions are scalar and branch-free, so that loops over the lanes of a packet vectorise. Directions may have any length,
// except for spheres.
#pragma once

#include <cstdint>

#include "core/multiversion.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

struct LaneRay {
  float ox, oy, oz, dx, dy, dz, t_near, t_far;
};

LIPPMANN_INLINE float nearest_valid(float t0, float t1, bool valid0, bool valid1) {
  const float second = valid1 ? t1 : kInfinity;
  return valid0 ? t0 : second;
}

struct WorldSphere {
  float x, y, z, radius;
};

/// The intersection of a ray with a sphere. The discriminant uses the part of (centre - origin) that is perpendicular to the
/// ray, which is accurate even for small, distant spheres: Haines, Gunther, Akenine-Moller, "Precision Improvements for
/// Ray/Sphere Intersection", Ray Tracing Gems, 2019.
struct SphereCrossing {
  float middle;        ///< t at the ray's point closest to the centre
  float discriminant;  ///< squared half length of the chord; negative if the ray misses
};

LIPPMANN_INLINE SphereCrossing crossing(const WorldSphere& s, const LaneRay& r) {
  const float cx = s.x - r.ox, cy = s.y - r.oy, cz = s.z - r.oz;
  const float b = cx * r.dx + cy * r.dy + cz * r.dz;
  const float px = cx - b * r.dx, py = cy - b * r.dy, pz = cz - b * r.dz;
  return {b, s.radius * s.radius - (px * px + py * py + pz * pz)};
}

LIPPMANN_INLINE float discriminant(const WorldSphere& s, const LaneRay& r) { return crossing(s, r).discriminant; }

LIPPMANN_INLINE float distance(const WorldSphere& s, const LaneRay& r) {
  const auto [b, squared] = crossing(s, r);
  const float half = std::sqrt(std::max(squared, 0.0f));
  const float t0 = b - half, t1 = b + half;
  const bool real = squared >= 0.0f;
  return nearest_valid(t0, t1, real & (t0 > r.t_near) & (t0 < r.t_far), real & (t1 > r.t_near) & (t1 < r.t_far));
}

/// Returns whether the ray intersects the primitive. Used for shadow rays.
template <class Primitive>
LIPPMANN_INLINE bool crosses(const Primitive& primitive, const LaneRay& r) {
  return distance(primitive, r) < kInfinity;
}

/// Half the chord is sqrt(squared). The condition b - sqrt(squared) > t_near is tested without the square root, by comparing
/// the square of b - t_near with `squared`.
LIPPMANN_INLINE bool crosses(const WorldSphere& s, const LaneRay& r) {
  const auto [b, squared] = crossing(s, r);
  const float past_near = b - r.t_near, past_far = b - r.t_far;
  const bool near_within = past_near * past_near < squared, far_within = past_far * past_far < squared;
  const bool first = (past_near > 0.0f) & !near_within & ((past_far < 0.0f) | far_within);
  const bool second = ((past_near > 0.0f) | near_within) & (past_far < 0.0f) & !far_within;
  return (squared >= 0.0f) & (first | second);
}

struct WorldCylinder {
  float x, y, z;
  float ax, ay, az;
  float length, radius;
};

LIPPMANN_INLINE float distance(const WorldCylinder& c, const LaneRay& r) {
  const float ox = r.ox - c.x, oy = r.oy - c.y, oz = r.oz - c.z;
  const float o_axial = ox * c.ax + oy * c.ay + oz * c.az;
  const float d_axial = r.dx * c.ax + r.dy * c.ay + r.dz * c.az;
  // The ray is projected to the plane perpendicular to the axis, where the cylinder is a circle.
  const float mx = r.dx - d_axial * c.ax, my = r.dy - d_axial * c.ay, mz = r.dz - d_axial * c.az;
  const float qx = ox - o_axial * c.ax, qy = oy - o_axial * c.ay, qz = oz - o_axial * c.az;
  const float a = mx * mx + my * my + mz * mz;
  const float inverse_a = 1.0f / std::max(a, 1e-20f);
  const float b = -(mx * qx + my * qy + mz * qz) * inverse_a;
  const float px = qx + b * mx, py = qy + b * my, pz = qz + b * mz;
  const float discriminant = c.radius * c.radius - (px * px + py * py + pz * pz);
  const float half = std::sqrt(std::max(discriminant, 0.0f) * inverse_a);
  const float t0 = b - half, t1 = b + half;
  const float h0 = o_axial + t0 * d_axial, h1 = o_axial + t1 * d_axial;
  const bool real = (discriminant >= 0.0f) & (a > 1e-20f);
  return nearest_valid(t0, t1, real & (t0 > r.t_near) & (t0 < r.t_far) & (h0 >= 0.0f) & (h0 <= c.length),
                       real & (t1 > r.t_near) & (t1 < r.t_far) & (h1 >= 0.0f) & (h1 <= c.length));
}

struct WorldPlane {
  float nx, ny, nz, offset;
};

LIPPMANN_INLINE float distance(const WorldPlane& p, const LaneRay& r) {
  const float along = p.nx * r.dx + p.ny * r.dy + p.nz * r.dz;
  const float height = p.offset - (p.nx * r.ox + p.ny * r.oy + p.nz * r.oz);
  const float t = height / along;  // +-inf or NaN for parallel rays, which fails the test below
  const bool valid = (t > r.t_near) & (t < r.t_far);
  return valid ? t : kInfinity;
}

struct WorldRing {
  float x, y, z, nx, ny, nz, inner, outer;
};

LIPPMANN_INLINE float distance(const WorldRing& g, const LaneRay& r) {
  const float cx = g.x - r.ox, cy = g.y - r.oy, cz = g.z - r.oz;
  const float t = (g.nx * cx + g.ny * cy + g.nz * cz) / (g.nx * r.dx + g.ny * r.dy + g.nz * r.dz);
  const float px = t * r.dx - cx, py = t * r.dy - cy, pz = t * r.dz - cz;
  const float squared = px * px + py * py + pz * pz;
  const bool valid = (t > r.t_near) & (t < r.t_far) & (squared >= g.inner * g.inner) & (squared <= g.outer * g.outer);
  return valid ? t : kInfinity;
}

struct WorldBox {
  float m[9];  ///< linear part of box_from_world, column by column
  float t[3];  ///< translation of box_from_world
  float center[3];
};

LIPPMANN_INLINE float distance(const WorldBox& b, const LaneRay& r) {
  const float ox = b.m[0] * r.ox + b.m[3] * r.oy + b.m[6] * r.oz + b.t[0];
  const float oy = b.m[1] * r.ox + b.m[4] * r.oy + b.m[7] * r.oz + b.t[1];
  const float oz = b.m[2] * r.ox + b.m[5] * r.oy + b.m[8] * r.oz + b.t[2];
  const float ix = 1.0f / (b.m[0] * r.dx + b.m[3] * r.dy + b.m[6] * r.dz);
  const float iy = 1.0f / (b.m[1] * r.dx + b.m[4] * r.dy + b.m[7] * r.dz);
  const float iz = 1.0f / (b.m[2] * r.dx + b.m[5] * r.dy + b.m[8] * r.dz);
  const float x0 = (-1.0f - ox) * ix, x1 = (1.0f - ox) * ix;
  const float y0 = (-1.0f - oy) * iy, y1 = (1.0f - oy) * iy;
  const float z0 = (-1.0f - oz) * iz, z1 = (1.0f - oz) * iz;
  const float enter = std::max(std::max(std::min(x0, x1), std::min(y0, y1)), std::min(z0, z1));
  const float leave = std::min(std::min(std::max(x0, x1), std::max(y0, y1)), std::max(z0, z1));
  const bool real = enter <= leave;
  return nearest_valid(enter, leave, real & (enter > r.t_near) & (enter < r.t_far),
                       real & (leave > r.t_near) & (leave < r.t_far));
}

WorldSphere to_world(const Affine3f& world_from_local, const struct Sphere& sphere);
WorldCylinder to_world(const Affine3f& world_from_local, const struct Cylinder& cylinder);
WorldPlane to_world(const Affine3f& world_from_local, const struct Plane& plane);
WorldRing to_world(const Affine3f& world_from_local, const struct Ring& ring);
WorldBox to_world(const Affine3f& world_from_local, const struct Box& box);

Bounds3f bounds(const WorldSphere& s);
Bounds3f bounds(const WorldCylinder& c);
Bounds3f bounds(const WorldRing& g);
Bounds3f bounds(const WorldBox& b);

/// Returns the outward normal at a surface point. It need not have unit length. Rings and planes return their stored normal.
LIPPMANN_INLINE Vec3f normal_at(const WorldSphere& s, Vec3f p) { return {p.x - s.x, p.y - s.y, p.z - s.z}; }
LIPPMANN_INLINE Vec3f normal_at(const WorldCylinder& c, Vec3f p) {
  const Vec3f axis(c.ax, c.ay, c.az), q = p - Vec3f(c.x, c.y, c.z);
  return q - glm::dot(q, axis) * axis;
}
LIPPMANN_INLINE Vec3f normal_at(const WorldRing& g, Vec3f) { return {g.nx, g.ny, g.nz}; }
LIPPMANN_INLINE Vec3f normal_at(const WorldPlane& p, Vec3f) { return {p.nx, p.ny, p.nz}; }
/// Returns the normal of the box's face that contains p: the face on the axis where p has its largest box coordinate.
Vec3f normal_at(const WorldBox& b, Vec3f p);
/// Returns the normal by Tachyon's rule: the world axis on which p - centre has its largest component. On elongated boxes, it
/// may differ from the face's normal.
Vec3f tachyon_box_normal(const WorldBox& b, Vec3f p);

}  // namespace lippmann

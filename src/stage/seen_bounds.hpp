// Computes the bounds of the parts of shapes inside a convex region, such as a camera's view. Other primitives than triangles
// count as their bounding boxes. Infinite planes are ignored.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

struct HalfSpace {
  Vec3f normal{0.0f};
  float offset = 0.0f;
};

using ConvexRegion = std::vector<HalfSpace>;

/// The view pyramid of an eye that looks along -z: |x| <= tangent.x depth and |y| <= tangent.y depth, relative to the eye.
ConvexRegion view_region(Vec3f eye, Vec2f tangent);

/// The view of an orthographic camera at the origin that looks along -z: |x| <= half.x and |y| <= half.y.
ConvexRegion beam_region(Vec2f half);

ConvexRegion box_region(const Bounds3f& box);

/// Calls visit(box) for each primitive of a shape. Infinite primitives have empty boxes.
void visit_boxes(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                 const std::function<void(const Bounds3f&)>& visit);

/// Receives the part of a polygon that is inside the region. Corners are in the frame of the region, and valid only during the
/// call.
using PolygonVisitor = std::function<void(std::span<const Vec3f> polygon)>;
void visit_seen(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                const ConvexRegion& region, const PolygonVisitor& visit);

/// `tangent` holds the largest |x| / depth and |y| / depth inside the region, seen from the origin along -z.
struct SeenParts {
  Bounds3f bounds;
  Vec2f tangent{0.0f};
  void add(const SeenParts& parts) { bounds.add(parts.bounds), tangent = glm::max(tangent, parts.tangent); }
};

SeenParts seen_parts(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                     const Affine3f& frame_from_world, const ConvexRegion& region);

}  // namespace lippmann

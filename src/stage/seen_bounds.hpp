// The bounds of those parts of shapes that lie inside a convex region, such as what a camera sees.
//
// Meshes are cut triangle by triangle and the result is exact; every other primitive counts as the box around it. Infinite
// planes are left out.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// The side of a plane where dot(normal, p) + offset >= 0.
struct HalfSpace {
  Vec3f normal{0.0f};
  float offset = 0.0f;
};

/// All points that lie in every half space.
using ConvexRegion = std::vector<HalfSpace>;

/// What a viewer at `eye` who looks along -z sees, in front of him: |x| <= tangent.x * depth and |y| <= tangent.y * depth.
ConvexRegion view_region(Vec3f eye, Vec2f tangent);

/// What an orthographic camera at the origin shows that looks along -z: |x| <= half.x and |y| <= half.y, in front of it.
ConvexRegion beam_region(Vec2f half);

/// Everything inside a box.
ConvexRegion box_region(const Bounds3f& box);

/// Calls visit(box) for the box around each primitive of a shape that is a list of them: a few hundred balls are seen where
/// they are, not where their common box is. A box is empty where a primitive is infinite.
void visit_boxes(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                 const std::function<void(const Bounds3f&)>& visit);

/// Calls visit(polygon) for each polygon that lies inside the region, cut by it, of one instance. Corners are in the frame that
/// the region is given in, and valid during the call.
using PolygonVisitor = std::function<void(std::span<const Vec3f> polygon)>;
void visit_seen(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                const ConvexRegion& region, const PolygonVisitor& visit);

/// `bounds` holds the parts; `tangent` the largest |x| / depth and |y| / depth as seen from the origin along -z.
struct SeenParts {
  Bounds3f bounds;
  Vec2f tangent{0.0f};
  void add(const SeenParts& parts) { bounds.add(parts.bounds), tangent = glm::max(tangent, parts.tangent); }
};

/// The bounds of one instance, in the frame that the region is given in.
SeenParts seen_parts(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                     const Affine3f& frame_from_world, const ConvexRegion& region);

}  // namespace lippmann

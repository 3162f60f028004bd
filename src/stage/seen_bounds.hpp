// Computes the bounds of the parts of shapes inside a convex region, such as a camera's view.
//
// Meshes are clipped triangle by triangle, so their bounds are exact. Other primitives count as their bounding boxes. Infinite
// planes are ignored.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// The half space dot(normal, p) + offset >= 0.
struct HalfSpace {
  Vec3f normal{0.0f};
  float offset = 0.0f;
};

/// The intersection of half spaces.
using ConvexRegion = std::vector<HalfSpace>;

/// Returns the view pyramid of an eye that looks along -z. It contains the points in front of the eye with |x| <= tangent.x
/// depth and |y| <= tangent.y depth, relative to the eye.
ConvexRegion view_region(Vec3f eye, Vec2f tangent);

/// Returns the view of an orthographic camera at the origin that looks along -z. It contains the points in front of the camera
/// with |x| <= half.x and |y| <= half.y.
ConvexRegion beam_region(Vec2f half);

ConvexRegion box_region(const Bounds3f& box);

/// Calls visit(box) with the bounding box of each primitive of a shape that is a list of primitives. Separate boxes of spheres
/// are more precise than their common box. The box of an infinite primitive is empty.
void visit_boxes(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                 const std::function<void(const Bounds3f&)>& visit);

/// Calls visit(polygon) for each polygon of an instance that remains inside the region after clipping. Corners are in the frame
/// of the region, and are valid only during the call.
using PolygonVisitor = std::function<void(std::span<const Vec3f> polygon)>;
void visit_seen(const Scene& scene, const Instance& instance, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                const ConvexRegion& region, const PolygonVisitor& visit);

/// The extent of the parts inside a region. `bounds` contains these parts. `tangent` holds their largest |x| / depth and |y| /
/// depth, as seen from the origin along -z.
struct SeenParts {
  Bounds3f bounds;
  Vec2f tangent{0.0f};
  void add(const SeenParts& parts) { bounds.add(parts.bounds), tangent = glm::max(tangent, parts.tangent); }
};

/// Returns the extent of the part of one instance inside the region, in the frame of the region.
SeenParts seen_parts(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                     const Affine3f& frame_from_world, const ConvexRegion& region);

}  // namespace lippmann

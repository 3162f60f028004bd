// Where the points that rays hit were in the frame before, as the display of then saw them.
//
// What moves with a node is taken back by the node's motion; of a mesh that changes its shape, the same place of the same
// triangle is looked up in the former pose. Composed in double precision.
#pragma once

#include <optional>
#include <vector>

#include "core/affine3d.hpp"
#include "scene/deform.hpp"
#include "shading/surface.hpp"
#include "trace/first_hits.hpp"

namespace lippmann {

class FormerPlaces {
 public:
  /// The device scene is as it is `now`. All arguments must outlive this.
  FormerPlaces(const ShadedScene& scene, const Affine3f& world_from_display, const FrameStep& step);

  /// Where the point of lane i, whose surface is evaluated, was in the frame before, in mm of its display. None: the point has
  /// not moved before the display.
  std::optional<Vec3f> of(const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

 private:
  struct OfInstance {
    bool still = true;
    Affine3d display_from_world;     ///< to the frame before, from world space now
    std::optional<MeshPose> pose{};  ///< in the frame before, where the mesh changes its shape
  };

  Vec3f posed_point(const MeshPose& pose, const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

  const ShadedScene& scene_;
  Affine3d display_before_from_world_;
  std::vector<OfInstance> instances_;
};

}  // namespace lippmann

// Finds where the surface points that rays hit in the current frame were in the previous frame.
//
// A point on a moving node is moved back by the node's motion. A point on a deforming mesh keeps its triangle and barycentric
// coordinates, and takes its position from the mesh's previous pose. The transforms are composed in double precision.
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
  /// `scene` must be at the time of `step.now`. All arguments must outlive this object.
  FormerPlaces(const ShadedScene& scene, const Affine3f& world_from_display, const FrameStep& step);

  /// Returns the previous position of the point that lane i's ray has hit, in mm relative to the display of the previous frame.
  /// Returns nothing if the point has not moved relative to the display. The surface of lane i must have been evaluated.
  std::optional<Vec3f> of(const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

 private:
  struct OfInstance {
    bool still = true;
    Affine3d display_from_world;     ///< maps current world space to mm relative to the display of the previous frame
    std::optional<MeshPose> pose{};  ///< pose in the previous frame; only for deforming meshes
  };

  Vec3f posed_point(const MeshPose& pose, const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

  const ShadedScene& scene_;
  Affine3d display_before_from_world_;
  std::vector<OfInstance> instances_;
};

}  // namespace lippmann

// Positions of ray hits in the previous frame, as seen from that frame's display.
//
// A point on a moving node is moved back by the node's motion. A point on a deforming mesh is found in the previous pose, with
// the same triangle and barycentric coordinates. The transforms are composed in double precision.
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
  /// The device scene must be in the state of `step.now`. All arguments must outlive this object.
  FormerPlaces(const ShadedScene& scene, const Affine3f& world_from_display, const FrameStep& step);

  /// Returns the position of lane i's hit in the previous frame, in mm of that frame's display, or nothing if the point has not
  /// moved relative to the display. The surface of the lane must have been evaluated.
  std::optional<Vec3f> of(const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

 private:
  struct OfInstance {
    bool still = true;
    Affine3d display_from_world;     ///< maps current world space to the display of the previous frame
    std::optional<MeshPose> pose{};  ///< pose in the previous frame; only for deforming meshes
  };

  Vec3f posed_point(const MeshPose& pose, const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

  const ShadedScene& scene_;
  Affine3d display_before_from_world_;
  std::vector<OfInstance> instances_;
};

}  // namespace lippmann

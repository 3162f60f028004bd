// Finds where the surface points of the current frame were in the previous frame.
//
// Points move with their nodes. On deforming meshes, a point keeps its triangle and barycentric coordinates.
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

  /// Returns the previous position of the point that lane i's ray has hit, in mm relative to the previous frame's display, or
  /// nothing if the point has not moved relative to the display. `surface` must be evaluated for lane i.
  std::optional<Vec3f> of(const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

 private:
  struct OfInstance {
    bool still = true;
    Affine3d display_from_world;  ///< maps current world space to mm relative to the previous frame's display
    std::optional<MeshPose> pose{};
  };

  Vec3f posed_point(const MeshPose& pose, const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

  const ShadedScene& scene_;
  Affine3d display_before_from_world_;
  std::vector<OfInstance> instances_;
};

}  // namespace lippmann

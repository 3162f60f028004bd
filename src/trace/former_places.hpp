// Positions of ray hits in the previous frame, relative to the display of that frame.
//
// A point on a moving node is moved back by the node's motion. A point on a deforming mesh has the same triangle and
// barycentric coordinates in the previous pose. The transforms are composed in double precision.
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
  /// `scene` must show the frame `step.now`. All arguments must outlive this object.
  FormerPlaces(const ShadedScene& scene, const Affine3f& world_from_display, const FrameStep& step);

  /// Returns the position of lane i's hit in the previous frame, in mm of that frame's display frame. Returns nothing if the
  /// point has not moved relative to the display. The lane's surface must have been evaluated.
  std::optional<Vec3f> of(const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

 private:
  struct OfInstance {
    bool still = true;
    Affine3d display_from_world;     ///< maps world space of the current frame to the display frame of the previous frame
    std::optional<MeshPose> pose{};  ///< pose in the previous frame; only for deforming meshes
  };

  Vec3f posed_point(const MeshPose& pose, const RayHitPacket& packet, const SurfacePacket& surface, int i) const;

  const ShadedScene& scene_;
  Affine3d display_before_from_world_;
  std::vector<OfInstance> instances_;
};

}  // namespace lippmann

// Records the first hits of camera rays while they are traced.
#pragma once

#include "shading/shaded_scene.hpp"
#include "trace/camera_packet.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// Threads may store packets at once if the packets have different pixels.
class PointCapture {
 public:
  /// `points` must have the size of the film. The scene and `points` must outlive this object.
  PointCapture(const ShadedScene& scene, const Affine3f& display_from_world, PrimaryPoints& points)
      : scene_(scene), display_from_world_(display_from_world), points_(points) {}

  void store(const CameraPacket& camera) const;

 private:
  const ShadedScene& scene_;
  Affine3f display_from_world_;
  PrimaryPoints& points_;
};

}  // namespace lippmann

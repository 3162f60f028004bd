// Keeps the first hits of primary packets while they are traced, so that a point image costs no rays of its own.
#pragma once

#include "shading/shaded_scene.hpp"
#include "trace/camera_packet.hpp"
#include "trace/primary_points.hpp"

namespace lippmann {

/// Thread-safe for packets of different pixels.
class PointCapture {
 public:
  /// `points` has the panel's size; both must outlive this.
  PointCapture(const ShadedScene& scene, const Affine3f& display_from_world, PrimaryPoints& points)
      : scene_(scene), display_from_world_(display_from_world), points_(points) {}

  /// Stores where the active lanes of a traced packet have ended.
  void store(const CameraPacket& camera) const;

 private:
  const ShadedScene& scene_;
  Affine3f display_from_world_;
  PrimaryPoints& points_;
};

}  // namespace lippmann

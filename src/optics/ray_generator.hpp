#pragma once

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/models.hpp"

namespace lippmann {

class RayGenerator {
 public:
  /// `optics` must pass validate(). `world_from_display` consists of a rotation, a uniform scale and a translation. Rays have
  /// origins in world units and unit directions. Without `world_from_display`, rays are in the display frame, in mm.
  explicit RayGenerator(const Optics& optics, const Affine3f& world_from_display = {});

  /// Computes the rays of `count` points of the panel, in continuous pixel coordinates. Rays of a RayTable start at their own
  /// origins, all others in the plane z = z_front (see resolved_z_front_mm()). A multiple of 16 points is most efficient. The
  /// arrays must not overlap.
  void rays(const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays) const;

  Ray ray(Vec2f pixel) const;

  /// Sets mark[i] to `value` for each point i whose light is blocked (is_blocked()).
  void mark_blocked(const float* pixel_x, const float* pixel_y, int count, float value, float* mark) const;

  Vec3f forward() const { return frame_.unit_forward; }

  /// Returns the distance between the planes where rays start and end, in world units along forward(). It is infinite if z_back
  /// is infinite. The length of a ray is depth() / dot(direction, forward()).
  float depth() const { return depth_; }

 private:
  AnyRays model_;
  RayFrame frame_;
  float depth_;
};

}  // namespace lippmann

// Rays of many pixels at once, in world space: what does not change from pixel to pixel is worked out once per frame.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/models.hpp"

namespace lippmann {

/// Thread-safe once made. Cheap enough to make per frame, not per packet.
class RayGenerator {
 public:
  /// `optics` must pass validate(). world_from_display: a rotation, one scale and a translation; rays come out in its target
  /// frame, origins in world units, directions of unit length. Without it: in the display frame, mm.
  explicit RayGenerator(const Optics& optics, const Affine3f& world_from_display = {});

  /// The rays of `count` points of the panel, in continuous pixel coordinates. They start in the plane z = z_front (see
  /// resolved_z_front_mm), those of a table at their own origins. Worked out in blocks of 16: best for multiples of that; the
  /// arrays must not overlap.
  void rays(const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays) const;

  /// The ray of one point, bit-identical to rays().
  Ray ray(Vec2f pixel) const;

  /// Unit vector along the display's -z, in world space.
  Vec3f forward() const { return frame_.unit_forward; }

  /// From the plane in which rays start to the one in which they end, world units along forward(); inf where z_back is. A ray's
  /// own length is depth() / dot(direction, forward()).
  float depth() const { return depth_; }

 private:
  AnyRays model_;
  RayFrame frame_;
  float depth_;
};

}  // namespace lippmann

// Moves the camera rays of views from their pinholes to points on a lens (lippmann/optics/view_lens.hpp).
#pragma once

#include "device/ray_packet.hpp"
#include "lippmann/optics/view_lens.hpp"

namespace lippmann {

/// Keys of the random numbers of sixteen rays: the index of the pixel in the whole film, and the sample number.
struct LensLanes {
  const std::uint32_t *pixel, *sample;
};

class ThinLens {
 public:
  /// `lens` must specify its aperture, not an f-number (lens_by_aperture). If the lens is open, the optics must be views and
  /// the focal plane must lie in front of their eyes.
  ThinLens(const Optics& optics, const Affine3f& world_from_display, const ViewLens& lens, std::uint32_t seed);

  bool is_open() const { return radius_ > 0.0f; }

  /// Moves sixteen pinhole rays to points on the lens: replaces their origin, direction and tfar. A pixel's samples are spread
  /// evenly over the disc.
  void spread(const LensLanes& lanes, RayPacket& rays) const;

 private:
  float radius_;  ///< in mm of the display
  std::uint32_t seed_;
  Vec3f right_, up_;     ///< world vectors of 1 mm on the lens
  Vec3f forward_;        ///< unit length
  float origin_share_;   ///< shift of the ray's origin relative to the shift of its point on the lens
  float inverse_focus_;  ///< 1 / distance from the eyes to the focal plane, in world units
};

}  // namespace lippmann

// Moves the camera rays of views from their pinholes to points on a lens (lippmann/optics/view_lens.hpp).
#pragma once

#include "device/ray_packet.hpp"
#include "lippmann/optics/view_lens.hpp"

namespace lippmann {

/// Inputs of the random numbers of sixteen rays: index of the pixel in the whole film, and sample number.
struct LensLanes {
  const std::uint32_t *pixel, *sample;
};

class ThinLens {
 public:
  /// `lens` must specify its aperture in mm instead of an f-number (see lens_by_aperture). If the aperture is above 0, the
  /// optics must consist of views, and the focal plane must lie in front of the views' eyes.
  ThinLens(const Optics& optics, const Affine3f& world_from_display, const ViewLens& lens, std::uint32_t seed);

  bool is_open() const { return radius_ > 0.0f; }

  /// Moves sixteen pinhole rays to points on the lens. Changes origin, direction and tfar of the rays. The samples of a pixel
  /// are spread evenly over the lens.
  void spread(const LensLanes& lanes, RayPacket& rays) const;

 private:
  float radius_;  ///< radius of the lens in mm of the display frame
  std::uint32_t seed_;
  Vec3f right_, up_;     ///< vectors of 1 mm across the lens, in world space
  Vec3f forward_;        ///< unit vector along the lens's axis
  float origin_share_;   ///< shift of a ray's origin divided by the shift of its point on the lens
  float inverse_focus_;  ///< 1 / distance from the eyes to the focal plane, in world units
};

}  // namespace lippmann

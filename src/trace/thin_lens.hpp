// Moves camera rays from pinholes to points on a lens (lippmann/optics/view_lens.hpp).
#pragma once

#include "device/ray_packet.hpp"
#include "lippmann/optics/view_lens.hpp"

namespace lippmann {

struct LensLanes {
  const std::uint32_t *pixel, *sample;
};

class ThinLens {
 public:
  /// `lens` must specify its aperture in mm instead of an f-number (see lens_by_aperture). If the aperture is above 0, the
  /// optics must be a set of views, and the focal plane must be in front of their eyes.
  ThinLens(const Optics& optics, const Affine3f& world_from_display, const ViewLens& lens, std::uint32_t seed);

  bool is_open() const { return radius_ > 0.0f; }

  /// Moves sixteen pinhole rays to points on the lens. Changes origin, direction and tfar of the rays.
  void spread(const LensLanes& lanes, RayPacket& rays) const;

 private:
  float radius_;
  std::uint32_t seed_;
  Vec3f right_, up_;
  Vec3f forward_;
  float origin_share_;  ///< shift of a ray's origin divided by the shift of its point on the lens
  float inverse_focus_;
};

}  // namespace lippmann

// Moves the camera rays of views from their pinholes to points of the lens in their place (lippmann/optics/view_lens.hpp).
#pragma once

#include "device/ray_packet.hpp"
#include "lippmann/optics/view_lens.hpp"

namespace lippmann {

/// The random numbers of sixteen rays: of which pixel of the whole film each is, and which of its samples.
struct LensLanes {
  const std::uint32_t *pixel, *sample;
};

class ThinLens {
 public:
  /// `lens` has no f-number any more (lens_by_aperture). The optics are views where it is open, and the focal plane lies in
  /// front of their eyes.
  ThinLens(const Optics& optics, const Affine3f& world_from_display, const ViewLens& lens, std::uint32_t seed);

  bool is_open() const { return radius_ > 0.0f; }

  /// Origin, direction and tfar of sixteen pinholes' rays become those of the lens. The samples of a pixel are spread evenly
  /// over the disc.
  void spread(const LensLanes& lanes, RayPacket& rays) const;

 private:
  float radius_;  ///< in the display's mm
  std::uint32_t seed_;
  Vec3f right_, up_;     ///< world vectors of 1 mm of the lens
  Vec3f forward_;        ///< unit length
  float origin_share_;   ///< of a step on the lens, by which rays move in the plane where they start
  float inverse_focus_;  ///< 1 / distance from the eyes to the focal plane, in the world
};

}  // namespace lippmann

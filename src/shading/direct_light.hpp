// Direct light from one light on a packet of surface points, with shadow rays, Lambert's N.L and Blinn's highlight.
//
// Based on: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980; J. F. Blinn, "Models of light
// reflection for computer synthesized pictures", SIGGRAPH 1977 (the half-vector highlight). We deviate: the highlight lacks the
// factor N.L, as in Tachyon.
#pragma once

#include "device/transmittance.hpp"
#include "shading/surface.hpp"

namespace lippmann {

/// Direct light, summed over lights, for each lane. The caller multiplies `diffuse` and `highlight` by the surface's colours.
struct DirectLight {
  Lanes3 diffuse;  ///< sum of light colour * N.L * visibility
  /// Sum of light colour * (N.H)^size * visibility. In Tachyon mode, highlights do not fade with the light and, on metal, are
  /// white.
  Lanes3 highlight;
};

struct ShadowPacket {
  ShadowPacket() { make_ready(rays); }

  alignas(64) RayPacket rays;
  LaneMask active;
  LaneMask lifted;  ///< lanes whose rays start at the smooth surface (smooth_lift.hpp); defined if any_lifted is true
  bool any_lifted = false;
  Lanes strength;               ///< falloff with distance, times fading in the cone; defined in active lanes
  Lanes arriving;               ///< strength * N.L; defined in active lanes
  Transmittance transmittance;  ///< transmittance of lanes that are not fully occluded; 1 before tracing
};

/// Fills `shadow` for one light. Lanes with strength * N.L <= least_light are inactive. Returns the number of active lanes.
int aim_at_light(const WhittedLight& light, const SurfacePacket& surface, float least_light, ShadowPacket& shadow);

/// Adds the light that arrives through traced shadow rays. `view` holds the rays that hit the surface.
void add_light(const WhittedLight& light, const SurfacePacket& surface, const RayPacket& view, const ShadowPacket& shadow,
               bool tachyon, DirectLight& direct);

}  // namespace lippmann

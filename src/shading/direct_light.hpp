// Direct light of a packet of surface points from one light: shadow rays, Lambert's N.L and Blinn's highlight.
//
// Based on: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980; J. F. Blinn, "Models of light
// reflection for computer synthesized pictures", SIGGRAPH 1977 (the half-vector highlight; like Tachyon, without the factor
// N.L).
#pragma once

#include "device/transmittance.hpp"
#include "shading/surface.hpp"

namespace lippmann {

/// Accumulated direct light per lane. The caller multiplies `diffuse` by the surface's colour and `highlight` by its tint.
struct DirectLight {
  Lanes3 diffuse;    ///< sum of light colour * N.L * visibility
  Lanes3 highlight;  ///< sum of light colour * (N.H)^size * visibility, before the surface's tint. In Tachyon mode it omits the
                     ///< light's fading and transmittance and, for metal, its colour.
};

/// Shadow rays from a packet of points to one light.
struct ShadowPacket {
  /// Initializes the ray fields that all packets share.
  ShadowPacket() { make_ready(rays); }

  alignas(64) RayPacket rays;
  LaneMask active;  ///< lanes whose surface faces the light, within its range and cone
  LaneMask lifted;  ///< lanes whose rays start from the smooth surface (smooth_lift.hpp); valid if any_lifted is set
  bool any_lifted = false;
  Lanes strength;               ///< factor of the light by distance and cone, for active lanes
  Lanes arriving;               ///< strength * N.L, for active lanes
  Transmittance transmittance;  ///< 1 before tracing; then the transmittance of lanes that are not fully occluded
};

/// Fills rays, active, strength and arriving. Light with strength * N.L <= least_light is ignored. Returns the number of active
/// lanes.
int aim_at_light(const WhittedLight& light, const SurfacePacket& surface, float least_light, ShadowPacket& shadow);

/// Adds the unoccluded light. `view`: the rays that hit the surface.
void add_light(const WhittedLight& light, const SurfacePacket& surface, const RayPacket& view, const ShadowPacket& shadow,
               bool tachyon, DirectLight& direct);

}  // namespace lippmann

// The light that a packet of surface points receives from one light: shadow rays, Lambert's N.L, Blinn's highlight.
//
// Based on: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980; J. F. Blinn, "Models of light
// reflection for computer synthesized pictures", SIGGRAPH 1977 (the half-vector highlight, without an N.L factor, as Tachyon
// has it).
#pragma once

#include "device/transmittance.hpp"
#include "shading/surface.hpp"

namespace lippmann {

/// Direct light gathered so far, per lane: what multiplies the surface's diffuse colour, and the highlights by their tint.
struct DirectLight {
  Lanes3 diffuse;    ///< sum of light colour x N.L x visibility
  Lanes3 highlight;  ///< sum of light colour x (N.H)^size x visibility, in the light's colour; tint comes later.
                     ///< Tachyon's: neither the light's fading and transmittance nor, in metal, its colour enter.
};

/// Rays from a packet of points to one light.
struct ShadowPacket {
  /// Sets what is the same for every packet.
  ShadowPacket() { make_ready(rays); }

  alignas(64) RayPacket rays;
  LaneMask active;  ///< lanes whose surface faces the light within its range and cone
  LaneMask lifted;  ///< lanes whose rays start from the smooth surface (smooth_lift.hpp); set where
  bool any_lifted = false;
  Lanes strength;               ///< what distance and cone leave of the light at the point, for active lanes
  Lanes arriving;               ///< strength x N.L, for active lanes
  Transmittance transmittance;  ///< 1; once traced, how much of the light passes in lanes that it does not end
};

/// Fills rays, active, strength and arriving. Light of strength x N.L <= least_light is none. Returns how many lanes are
/// active.
int aim_at_light(const WhittedLight& light, const SurfacePacket& surface, float least_light, ShadowPacket& shadow);

/// Adds what arrives. `view`: the rays that hit the surface.
void add_light(const WhittedLight& light, const SurfacePacket& surface, const RayPacket& view, const ShadowPacket& shadow,
               bool tachyon, DirectLight& direct);

}  // namespace lippmann

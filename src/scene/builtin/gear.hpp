// Involute gears: tooth shapes, solid meshes, and the angles at which gears mesh.
//
// A gear lies in the x-y plane with axis z; one of its teeth (for a ring: one of its gaps) is centred on +x. Lengths are in
// modules (pitch diameter / teeth), so that any two gears mesh if the distance between their centres is half the sum of their
// tooth counts.
#pragma once

#include "scene/builtin/planar_region.hpp"

namespace lippmann::builtin {

inline constexpr float kPressureAngle = radians(25.0f);
inline constexpr float kAddendum = 1.0f, kDedendum = 1.25f;
/// The backlash between two meshing gears along the pitch circle, half of it on each gear.
inline constexpr float kBacklash = 0.06f;

inline constexpr float pitch_radius(int teeth) { return 0.5f * static_cast<float>(teeth); }

/// Returns half the angle of a tooth at a radius between the base circle and the tip. Below the base circle it is constant.
float tooth_half_angle(int teeth, float radius);
/// Returns half the angle of a tooth of an internal ring, whose teeth point inwards.
float ring_tooth_half_angle(int teeth, float radius);

struct GearBlank {
  float thickness = 4.0f;
  float bevel = 0.12f;
  float bore_radius = 1.0f;
  int spokes = 0;            ///< 0: a solid disc
  float spoke_width = 2.0f;  ///< width at the hub; three quarters of it at the rim
  float rim_width = 2.0f;    ///< width of the rim, from the root circle inwards
  float hub_radius = 2.5f;
};

Mesh gear_mesh(int teeth, const GearBlank& blank);

/// Returns a ring with teeth inside and outside. Only thickness and bevel of `blank` apply.
Mesh ring_gear_mesh(int inner_teeth, int outer_teeth, const GearBlank& blank);

/// Returns the rotation of a gear that meshes with a driver rotated by `driver_angle`. `direction`: angle from the driver's
/// centre to the gear's.
float meshing_angle(int driver_teeth, float driver_angle, int teeth, float direction);

}  // namespace lippmann::builtin

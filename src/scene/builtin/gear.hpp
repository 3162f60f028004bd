// Involute gears: tooth shapes, solid meshes, and the rotation angles at which gears mesh.
//
// A gear lies in the x-y plane and rotates about z. A tooth is centred on +x. In an internal ring, a gap is centred
// on +x. The unit of length is the module: the pitch diameter divided by the number of teeth. Two gears mesh if the distance
// between their centres is half the sum of their tooth counts.
#pragma once

#include "scene/builtin/planar_region.hpp"

namespace lippmann::builtin {

inline constexpr float kPressureAngle = radians(25.0f);
inline constexpr float kAddendum = 1.0f, kDedendum = 1.25f;
/// Gap between the teeth of two meshing gears, measured along the pitch circle. Each gear provides half of it.
inline constexpr float kBacklash = 0.06f;

inline constexpr float pitch_radius(int teeth) { return 0.5f * static_cast<float>(teeth); }

/// Returns half the angle of a tooth at a radius, in radians. Below the base circle, the angle is constant.
float tooth_half_angle(int teeth, float radius);
/// Returns tooth_half_angle() for the teeth of an internal ring, which point inwards.
float ring_tooth_half_angle(int teeth, float radius);

struct GearBlank {
  float thickness = 4.0f;
  float bevel = 0.12f;
  float bore_radius = 1.0f;
  int spokes = 0;
  float spoke_width = 2.0f;
  float rim_width = 2.0f;
  float hub_radius = 2.5f;
};

Mesh gear_mesh(int teeth, const GearBlank& blank);

/// Returns a ring with teeth on its inside and its outside. Only the thickness and the bevel of `blank` are used.
Mesh ring_gear_mesh(int inner_teeth, int outer_teeth, const GearBlank& blank);

/// Returns the angle by which to rotate a gear so that it meshes with a driver that is rotated by `driver_angle`. `direction`
/// is the angle of the line from the driver's centre to the gear's centre. All angles are in radians.
float meshing_angle(int driver_teeth, float driver_angle, int teeth, float direction);

}  // namespace lippmann::builtin

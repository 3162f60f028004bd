// Involute gears: the shape of their teeth, solid meshes, and the phases at which they mesh.
//
// A gear lies in the x-y plane, its axis is z, and one of its teeth (of a ring: of its spaces) is centred on +x. All lengths
// are in modules (pitch diameter / teeth), so that gears of any tooth counts mesh at a centre distance of half their sum.
#pragma once

#include "scene/builtin/planar_region.hpp"

namespace lippmann::builtin {

inline constexpr float kPressureAngle = radians(25.0f);
inline constexpr float kAddendum = 1.0f, kDedendum = 1.25f;
/// The play between two gears in mesh, along the pitch circle; each tooth gives half of it.
inline constexpr float kBacklash = 0.06f;

inline constexpr float pitch_radius(int teeth) { return 0.5f * static_cast<float>(teeth); }

/// Half the angle that a tooth spans at a radius between the base circle and the tip; below the base circle it does not grow.
float tooth_half_angle(int teeth, float radius);
/// The same of the teeth of an internal ring, which point inwards.
float ring_tooth_half_angle(int teeth, float radius);

struct GearBlank {
  float thickness = 4.0f;
  float bevel = 0.12f;
  float bore_radius = 1.0f;
  int spokes = 0;            ///< 0: a solid disc
  float spoke_width = 2.0f;  ///< at the hub; three quarters of it at the rim
  float rim_width = 2.0f;    ///< below the roots
  float hub_radius = 2.5f;
};

Mesh gear_mesh(int teeth, const GearBlank& blank);

/// A ring with teeth inside and outside; of `blank`, thickness and bevel count.
Mesh ring_gear_mesh(int inner_teeth, int outer_teeth, const GearBlank& blank);

/// The rotation of a gear that meshes with a driver turned by `driver_angle`; `direction`: of its centre, seen from the
/// driver's.
float meshing_angle(int driver_teeth, float driver_angle, int teeth, float direction);

}  // namespace lippmann::builtin

// Based on: Faydor L. Litvin, Alfonso Fuentes, "Gear Geometry and Applied Theory", 2nd ed., 2004, chapters 10 (involute spur
// gears) and 11 (internal gears).
//
// Let inv(a) = tan a - a. Let r_p be the pitch radius and r_b = r_p cos(pressure angle) the base radius. At radius r, a tooth
// of a gear with z teeth has the half angle
//   psi(r) = pi / (2 z) + inv(pressure angle) - inv(acos(r_b / r)).
// The gaps of a ring have the shape of the teeth of a gear with equally many teeth. Therefore the ring's own teeth have the
// half angle pi / z - psi(r).
//
// We deviate:
// 1. Flanks below the base circle are radial instead of trochoids.
// 2. Each side of a tooth recedes by a quarter of the backlash.
#include "scene/builtin/gear.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann::builtin {
namespace {

constexpr int kFlankSteps = 6;

float involute(float angle) { return std::tan(angle) - angle; }

float involute_half_angle(int teeth, float radius) {
  const float base = pitch_radius(teeth) * std::cos(kPressureAngle);
  const float angle_at_radius = std::acos(std::min(1.0f, base / radius));
  return 0.5f * kPi / static_cast<float>(teeth) + involute(kPressureAngle) - involute(angle_at_radius);
}

Vec2f polar(float radius, float angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

/// Adds teeth between two radii as strips of triangles. `half_angle(radius)` returns half the angle of a tooth. The first tooth
/// is centred on `first_angle`. Returns the points of the root circle: both ends of each tooth, and two points between
/// neighbouring teeth.
template <class HalfAngle>
AngularRing add_teeth(PlanarRegion& region, int teeth, float first_angle, float root, float tip, const HalfAngle& half_angle) {
  AngularRing root_ring;
  const float pitch = 2.0f * kPi / static_cast<float>(teeth);
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const float center = first_angle + pitch * static_cast<float>(tooth);
    std::uint32_t left = 0, right = 0;
    for (int step = 0; step <= kFlankSteps; ++step) {
      const float radius = glm::mix(root, tip, static_cast<float>(step) / kFlankSteps);
      const float half = half_angle(radius);
      const std::uint32_t new_right = region.add(polar(radius, center - half)),
                          new_left = region.add(polar(radius, center + half));
      if (step == 0) {
        root_ring.add(new_right, center - half);
        root_ring.add(new_left, center + half);
      } else if (tip > root) {
        region.triangles.push_back({right, new_right, new_left});
        region.triangles.push_back({right, new_left, left});
      } else {
        region.triangles.push_back({right, new_left, new_right});
        region.triangles.push_back({right, left, new_left});
      }
      left = new_left, right = new_right;
    }
    const float half = half_angle(root), space = pitch - 2.0f * half;
    for (const float share : {1.0f / 3.0f, 2.0f / 3.0f}) {
      const float angle = center + half + share * space;
      root_ring.add(region.add(polar(root, angle)), angle);
    }
  }
  return root_ring;
}

AngularRing add_outer_teeth(PlanarRegion& region, int teeth) {
  const float radius = pitch_radius(teeth);
  return add_teeth(region, teeth, 0.0f, radius - kDedendum, radius + kAddendum,
                   [=](float r) { return tooth_half_angle(teeth, r); });
}

AngularRing add_inner_teeth(PlanarRegion& region, int teeth) {
  const float radius = pitch_radius(teeth);
  return add_teeth(region, teeth, kPi / static_cast<float>(teeth), radius + kDedendum, radius - kAddendum,
                   [=](float r) { return ring_tooth_half_angle(teeth, r); });
}

/// Adds a circle with `per_spoke` + 1 points across each spoke, and `per_gap` - 1 points before the next spoke.
AngularRing add_spoked_circle(PlanarRegion& region, float radius, int spokes, float width, int per_spoke, int per_gap) {
  AngularRing ring;
  const float pitch = 2.0f * kPi / static_cast<float>(spokes), half = std::asin(0.5f * width / radius);
  for (int spoke = 0; spoke < spokes; ++spoke) {
    const float center = pitch * static_cast<float>(spoke);
    const auto add = [&](float angle) { ring.add(region.add(polar(radius, angle)), angle); };
    for (int i = 0; i <= per_spoke; ++i)
      add(center + half * (2.0f * static_cast<float>(i) / static_cast<float>(per_spoke) - 1.0f));
    for (int i = 1; i < per_gap; ++i)
      add(center + half + (pitch - 2.0f * half) * static_cast<float>(i) / static_cast<float>(per_gap));
  }
  return ring;
}

AngularRing add_circle(PlanarRegion& region, float radius, int count) {
  AngularRing ring;
  for (int i = 0; i < count; ++i) {
    const float angle = 2.0f * kPi * static_cast<float>(i) / static_cast<float>(count);
    ring.add(region.add(polar(radius, angle)), angle);
  }
  return ring;
}

void fill_spokes(PlanarRegion& region, const AngularRing& hub, const AngularRing& rim, int spokes, int per_spoke, int per_gap) {
  for (int spoke = 0; spoke < spokes; ++spoke)
    for (int i = 0; i < per_spoke; ++i) {
      const std::size_t at = static_cast<std::size_t>(spoke * (per_spoke + per_gap) + i);
      region.triangles.push_back({hub.points[at], rim.points[at], rim.points[at + 1]});
      region.triangles.push_back({hub.points[at], rim.points[at + 1], hub.points[at + 1]});
    }
}

}  // namespace

float tooth_half_angle(int teeth, float radius) {
  return involute_half_angle(teeth, radius) - 0.25f * kBacklash / pitch_radius(teeth);
}

float ring_tooth_half_angle(int teeth, float radius) {
  return kPi / static_cast<float>(teeth) - involute_half_angle(teeth, radius) - 0.25f * kBacklash / pitch_radius(teeth);
}

Mesh gear_mesh(int teeth, const GearBlank& blank) {
  PlanarRegion region;
  const AngularRing roots = add_outer_teeth(region, teeth);
  const AngularRing bore = add_circle(region, blank.bore_radius, 48);
  if (blank.spokes == 0) {
    fill_between(region, bore, roots);
  } else {
    constexpr int kPerSpoke = 4;
    const int per_gap = 64 / blank.spokes;
    const float rim_radius = pitch_radius(teeth) - kDedendum - blank.rim_width;
    const AngularRing rim = add_spoked_circle(region, rim_radius, blank.spokes, 0.75f * blank.spoke_width, kPerSpoke, per_gap);
    const AngularRing hub = add_spoked_circle(region, blank.hub_radius, blank.spokes, blank.spoke_width, kPerSpoke, per_gap);
    fill_between(region, rim, roots);
    fill_spokes(region, hub, rim, blank.spokes, kPerSpoke, per_gap);
    fill_between(region, bore, hub);
  }
  return extrude(region, blank.thickness, blank.bevel);
}

Mesh ring_gear_mesh(int inner_teeth, int outer_teeth, const GearBlank& blank) {
  PlanarRegion region;
  const AngularRing inner = add_inner_teeth(region, inner_teeth);
  const AngularRing outer = add_outer_teeth(region, outer_teeth);
  fill_between(region, inner, outer);
  return extrude(region, blank.thickness, blank.bevel);
}

float meshing_angle(int driver_teeth, float driver_angle, int teeth, float direction) {
  // If a tooth of the driver is at the angle d from the line of centres, the gap that it enters is at -d * driver_teeth /
  // teeth.
  const float ratio = static_cast<float>(driver_teeth) / static_cast<float>(teeth);
  return direction + kPi + kPi / static_cast<float>(teeth) - ratio * (driver_angle - direction);
}

}  // namespace lippmann::builtin

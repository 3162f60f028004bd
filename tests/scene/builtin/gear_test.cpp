#include "scene/builtin/gear.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "mesh_checks.hpp"

namespace lippmann::builtin {
namespace {

constexpr GearBlank kBlank{.thickness = 4.0f, .bevel = 0.1f, .bore_radius = 1.0f};

float from_tooth(int teeth, float gear_angle, Vec2f p) {
  return std::remainder(std::atan2(p.y, p.x) - gear_angle, 2.0f * kPi / static_cast<float>(teeth));
}

/// Distance of p from the nearest flank along the circle around the gear's centre: negative inside the gear, infinite
/// beyond the tips.
float clearance(int teeth, float gear_angle, Vec2f p) {
  const float radius = glm::length(p);
  if (radius > pitch_radius(teeth) + kAddendum) return kInfinity;
  if (radius < pitch_radius(teeth) - kDedendum) return -1.0f;
  return radius * (std::abs(from_tooth(teeth, gear_angle, p)) - tooth_half_angle(teeth, radius));
}

/// Clearance for the inner teeth of a ring. `ring_angle` is the direction of the centre of a gap between teeth.
float ring_clearance(int teeth, float ring_angle, Vec2f p) {
  const float radius = glm::length(p);
  if (radius < pitch_radius(teeth) - kAddendum) return kInfinity;
  if (radius > pitch_radius(teeth) + kDedendum) return -1.0f;
  const float tooth_angle = ring_angle + kPi / static_cast<float>(teeth);
  return radius * (std::abs(from_tooth(teeth, tooth_angle, p)) - ring_tooth_half_angle(teeth, radius));
}

/// Angle of a ring that meshes with a gear inside it. The gear is rotated by `gear_angle`, and its centre lies in the
/// direction `direction` from the ring's centre.
float ring_meshing_angle(int gear_teeth, float gear_angle, int ring_teeth, float direction) {
  // Gear and ring rotate in the same direction. A tooth of the gear at angle d from the line of centres fills a gap of
  // the ring at d * gear_teeth / ring_teeth.
  return direction + static_cast<float>(gear_teeth) / static_cast<float>(ring_teeth) * (gear_angle - direction);
}

std::vector<Vec2f> flank_points(int teeth, float gear_angle) {
  std::vector<Vec2f> points;
  for (int tooth = 0; tooth < teeth; ++tooth)
    for (int step = 0; step <= 40; ++step)
      for (const float side : {-1.0f, 1.0f}) {
        const float radius = pitch_radius(teeth) + glm::mix(-kDedendum, kAddendum, static_cast<float>(step) / 40.0f);
        const float angle = gear_angle + 2.0f * kPi * static_cast<float>(tooth) / static_cast<float>(teeth) +
                            side * tooth_half_angle(teeth, radius);
        points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
  return points;
}

Vec2f along(float angle, float distance) { return {distance * std::cos(angle), distance * std::sin(angle)}; }

TEST(ToothHalfAngle, quarter_pitch_less_backlash_at_pitch_circle) {
  EXPECT_NEAR(tooth_half_angle(20, 10.0f), kPi / 40.0f - kBacklash / 40.0f, 1e-6f);
  EXPECT_NEAR(ring_tooth_half_angle(20, 10.0f), kPi / 40.0f - kBacklash / 40.0f, 1e-6f);
}

TEST(ToothHalfAngle, is_largest_at_the_base_circle) {
  // Half angle of a tooth at the base circle of radius 10 cos(25 degrees) = 9.06308: pi / 40 + inv(25 degrees) -
  // backlash / (4 * 10), with the pitch radius 10. The involute function inv(a) = tan a - a is 0.466308 - 0.436332 =
  // 0.029975.
  EXPECT_NEAR(tooth_half_angle(20, 9.06308f), kPi / 40.0f + 0.029975f - kBacklash / 40.0f, 3e-4f);
  EXPECT_FLOAT_EQ(tooth_half_angle(20, 8.8f), tooth_half_angle(20, 9.0f));
}

TEST(MeshingAngle, tooth_meets_gap_on_line_of_centres) {
  // The gear is to the right of the driver, and a tooth of the driver points to +x. There, a gap of the gear points to
  // -x, so the gear's next tooth is at pi + pi / 24.
  const float angle = meshing_angle(12, 0.0f, 24, 0.0f);
  EXPECT_NEAR(std::remainder(angle - kPi - kPi / 24.0f, 2.0f * kPi / 24.0f), 0.0f, 1e-5f);
}

TEST(MeshingAngle, gears_mesh_without_touching_or_slack) {
  for (const auto& [driver, teeth] : {std::pair{12, 12}, std::pair{48, 24}, std::pair{40, 20}, std::pair{48, 16}})
    for (const float direction : {0.0f, 0.8f, -2.0f})
      for (int step = 0; step < 10; ++step) {
        const float driver_angle = 0.037f * static_cast<float>(step);
        const float angle = meshing_angle(driver, driver_angle, teeth, direction);
        const Vec2f center = along(direction, pitch_radius(driver) + pitch_radius(teeth));
        float least = kInfinity;
        for (const Vec2f& p : flank_points(teeth, angle)) least = std::min(least, clearance(driver, driver_angle, center + p));
        // Perpendicular to the flanks, the clearance on each side is half of the backlash. Here it is measured along
        // circles, so the limits are wider.
        EXPECT_GT(least, 0.25f * kBacklash) << driver << " drives " << teeth;
        EXPECT_LT(least, 1.0f * kBacklash) << driver << " drives " << teeth;
      }
}

TEST(RingTooth, gear_meshes_inside_a_ring) {
  for (const float direction : {0.0f, 1.9f})
    for (int step = 0; step < 10; ++step) {
      const float gear_angle = 0.053f * static_cast<float>(step);
      const float ring_angle = ring_meshing_angle(12, gear_angle, 36, direction);
      const Vec2f center = along(direction, pitch_radius(36) - pitch_radius(12));
      float least = kInfinity;
      for (const Vec2f& p : flank_points(12, gear_angle)) least = std::min(least, ring_clearance(36, ring_angle, center + p));
      EXPECT_GT(least, 0.25f * kBacklash);
      EXPECT_LT(least, 1.0f * kBacklash);
    }
}

TEST(GearMesh, is_a_closed_solid_with_unit_normals) {
  GearBlank spoked = kBlank;
  spoked.spokes = 5;
  for (const Mesh& mesh : {gear_mesh(12, kBlank), gear_mesh(24, spoked), ring_gear_mesh(36, 48, kBlank)}) {
    EXPECT_TRUE(test::boundary_edges(mesh).empty());
    EXPECT_EQ(test::count_degenerate(mesh), 0);
    EXPECT_EQ(test::count_normals_not_unit(mesh), 0);
    EXPECT_EQ(test::count_facing_wrong(mesh), 0);
  }
}

TEST(GearMesh, volume_is_about_the_pitch_disc) {
  // Teeth fill a little less than half of the area between root and tip circle. The tolerance of 3 % covers this, the
  // bevels and the polygonal bore.
  const double expected = M_PI * (10.0 * 10.0 - 1.0) * 4.0;
  EXPECT_NEAR(test::signed_volume(gear_mesh(20, kBlank)) / expected, 1.0, 0.03);
}

}  // namespace
}  // namespace lippmann::builtin

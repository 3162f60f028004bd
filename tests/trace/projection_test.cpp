#include "shading/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lippmann {
namespace {

// rounding of one arc tangent and one division
constexpr float kProjectionRounding = 1e-6f;

struct ProjectedPoint {
  float u, v, blur;
};

ProjectedPoint project(const ImageProjection& projection, Vec3f point, float path_length) {
  constexpr int kLane = 5;
  Lanes3 points;
  Lanes lengths;
  LaneMask wanted;
  for (int i = 0; i < kLanes; ++i) {
    points.set(i, Vec3f(std::numeric_limits<float>::quiet_NaN()));
    lengths[i] = kInfinity;
    wanted.lane[i] = i == kLane ? -1 : 0;
  }
  points.set(kLane, point);
  lengths[kLane] = path_length;
  ProjectedLanes at;
  project(projection, points, lengths, wanted, at);
  return {at.u[kLane], at.v[kLane], at.blur[kLane]};
}

ImageProjection projection(ProjectionKind kind) {
  ImageProjection p;
  p.kind = kind;
  p.center = {10, 20, 30};
  return p;
}

TEST(Project, plane_takes_coordinates_along_its_axes) {
  ImageProjection p = projection(ProjectionKind::kPlane);
  p.scale = {0.5f, -0.25f, 100.0f};
  p.rotate = {0.1f, 0.2f, 0.0f};
  // Relative to the centre, the point is U = 3 along u_axis and V = 1 along v_axis. u: 0.5 x 3 + 0.1 = 1.6, whose
  // fraction is 0.6. v: -0.25 x 1 + 0.2 = -0.05, whose fraction is 0.95. Blur: 0.05 of the length 8, scaled by 0.5:
  // 0.2. scale.z has no effect.
  const ProjectedPoint at = project(p, {13, 21, 77}, 8.0f);
  EXPECT_NEAR(at.u, 0.6f, kProjectionRounding);
  EXPECT_NEAR(at.v, 0.95f, kProjectionRounding);
  EXPECT_NEAR(at.blur, 0.2f, kProjectionRounding);
}

TEST(Project, blur_ends_at_1) { EXPECT_EQ(project(projection(ProjectionKind::kPlane), {0, 0, 0}, 1e6f).blur, 1.0f); }

/// Angles around y are measured from x towards v_axis x u_axis = -z, in turns: 0 at x, 1/4 at -z, 1/2 at -x, 3/4 at z.
TEST(Project, cylinder_starts_at_u_axis_around_v_axis) {
  const ImageProjection p = projection(ProjectionKind::kCylinder);
  EXPECT_NEAR(project(p, {12, 20, 30}, 1.0f).u, 0.0f, kProjectionRounding);
  EXPECT_NEAR(project(p, {10, 20, 28}, 1.0f).u, 0.25f, kProjectionRounding);
  EXPECT_NEAR(project(p, {8, 20, 30}, 1.0f).u, 0.5f, kProjectionRounding);
  EXPECT_NEAR(project(p, {10, 20, 33}, 1.0f).u, 0.75f, kProjectionRounding);
}

TEST(Project, cylinder_uses_height_and_distance) {
  ImageProjection p = projection(ProjectionKind::kCylinder);
  p.scale = {2.0f, 3.0f, 0.0f};
  // The point is 3 from the axis of the cylinder and 4.1 along it.
  const ProjectedPoint at = project(p, {13, 24.1f, 30}, 40.0f);
  // v is the fraction of 4.1 x scale.y = 12.3, of which a float keeps about 6 digits.
  EXPECT_NEAR(at.v, 0.3f, 1e-5f);
  EXPECT_NEAR(at.blur, 0.05f * 40.0f / (8.0f * std::hypot(3.0f, 4.1f)) * 3.0f, kProjectionRounding);
}

TEST(Project, sphere_runs_from_pole_to_pole) {
  const ImageProjection p = projection(ProjectionKind::kSphere);
  EXPECT_NEAR(project(p, {11, 20, 30}, 1.0f).v, 0.5f, kProjectionRounding);
  EXPECT_NEAR(project(p, {11, 21, 30}, 1.0f).v, 0.75f, kProjectionRounding);
  EXPECT_NEAR(project(p, {11, 19, 30}, 1.0f).v, 0.25f, kProjectionRounding);
  EXPECT_NEAR(project(p, {10, 19, 30}, 1.0f).v, 0.0f, kProjectionRounding);
  EXPECT_NEAR(project(p, {10, 20, 29}, 1.0f).u, 0.25f, kProjectionRounding);
}

TEST(Project, centre_has_coordinates) {
  for (const ProjectionKind kind : {ProjectionKind::kCylinder, ProjectionKind::kSphere}) {
    const ProjectedPoint at = project(projection(kind), {10, 20, 30}, 1.0f);
    EXPECT_TRUE(at.u >= 0.0f && at.u <= 1.0f && at.v >= 0.0f && at.v <= 1.0f && at.blur == 1.0f);
  }
}

}  // namespace
}  // namespace lippmann

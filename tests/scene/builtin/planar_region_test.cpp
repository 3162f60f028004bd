#include "scene/builtin/planar_region.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_checks.hpp"

namespace lippmann::builtin {
namespace {

AngularRing add_polygon(PlanarRegion& region, float radius, int corners, float first_angle) {
  AngularRing ring;
  for (int i = 0; i < corners; ++i) {
    const float angle = first_angle + 2.0f * kPi * static_cast<float>(i) / static_cast<float>(corners);
    ring.add(region.add({radius * std::cos(angle), radius * std::sin(angle)}), angle);
  }
  return ring;
}

double polygon_area(int corners, double radius) { return 0.5 * corners * radius * radius * std::sin(2.0 * M_PI / corners); }

double area(const PlanarRegion& region) {
  double sum = 0.0;
  for (const auto& [a, b, c] : region.triangles) {
    const Vec2f u = region.points[b] - region.points[a], v = region.points[c] - region.points[a];
    EXPECT_GT(u.x * v.y - u.y * v.x, 0.0f);
    sum += 0.5 * static_cast<double>(u.x * v.y - u.y * v.x);
  }
  return sum;
}

TEST(FillBetween, joins_rings_of_different_counts) {
  for (const float first_angle : {-1.0f, 0.3f, 3.0f}) {
    PlanarRegion region;
    const AngularRing inner = add_polygon(region, 1.0f, 5, 0.3f), outer = add_polygon(region, 2.0f, 12, first_angle);
    fill_between(region, inner, outer);
    EXPECT_EQ(region.triangles.size(), 5u + 12u);
    EXPECT_NEAR(area(region), polygon_area(12, 2.0) - polygon_area(5, 1.0), 1e-5);
  }
}

TEST(Extrude, square_ring_becomes_a_closed_solid) {
  PlanarRegion region;
  const AngularRing inner = add_polygon(region, 1.0f, 4, 0.0f), outer = add_polygon(region, 2.0f, 4, 0.0f);
  fill_between(region, inner, outer);
  const Mesh mesh = extrude(region, 0.5f, 0.0625f);
  EXPECT_TRUE(test::boundary_edges(mesh).empty());
  EXPECT_EQ(test::count_degenerate(mesh), 0);
  EXPECT_EQ(test::count_facing_wrong(mesh), 0);
  // The square ring has the area 8 - 2 = 6 and the boundary length P = 4 * (2 + 1) * sqrt(2). Moving the boundary
  // inwards by d leaves 6 - d P, because the terms 4 d^2 of outer and inner corners cancel. A bevel of width w at each
  // face removes the volume P w^2 / 2, so 6 * 0.5 - 2 * P w^2 / 2 is left.
  const double w = 0.0625, perimeter = 12.0 * std::sqrt(2.0);
  EXPECT_NEAR(test::signed_volume(mesh), 3.0 - perimeter * w * w, 1e-5);
}

TEST(Extrude, faces_are_flat_and_bevels_are_creased) {
  PlanarRegion region;
  const AngularRing inner = add_polygon(region, 1.0f, 48, 0.0f), outer = add_polygon(region, 2.0f, 48, 0.0f);
  fill_between(region, inner, outer);
  const Mesh mesh = extrude(region, 0.5f, 0.05f);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const float up = std::abs(mesh.normals[i].z);
    // |normal.z| is 1 for faces, 0 for walls, and sqrt(1/2) for bevels, with a tolerance for the polygon with 48
    // corners.
    EXPECT_TRUE(up > 0.999f || up < 1e-3f || std::abs(up - std::sqrt(0.5f)) < 0.01f) << up;
  }
}

}  // namespace
}  // namespace lippmann::builtin

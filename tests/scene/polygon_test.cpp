#include "scene/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lippmann {
namespace {

glm::dvec3 area_vector(const std::vector<Vec3f>& p, const Triangle& t) {
  return 0.5 * glm::cross(glm::dvec3(p[t[1]] - p[t[0]]), glm::dvec3(p[t[2]] - p[t[0]]));
}

/// The triangles fill a polygon in a plane z = const if none is clockwise and their areas add up to `area`. Coordinates
/// are small whole numbers, so that floats are exact.
void expect_fills(const std::vector<Vec3f>& polygon, double area) {
  const std::vector<Triangle> triangles = triangulate(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    const glm::dvec3 a = area_vector(polygon, t);
    EXPECT_GE(a.z, 0.0);
    sum += a.z;
  }
  EXPECT_EQ(sum, area);
}

TEST(Polygon, convex_ones_become_fans) {
  EXPECT_EQ(triangulate(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygon, notch_stays_open) {
  // The area is 4 x 4 minus the triangle (0, 4), (2, 1), (4, 4) of area 6.
  expect_fills({{0, 0, 5}, {4, 0, 5}, {4, 4, 5}, {2, 1, 5}, {0, 4, 5}}, 10.0);
}

TEST(Polygon, comb_is_filled_from_any_corner) {
  // a bar of 7 x 1 with four teeth of 1 x 3 each
  std::vector<Vec3f> teeth = {{0, 0, 0}, {7, 0, 0}, {7, 4, 0}, {6, 4, 0}, {6, 1, 0}, {5, 1, 0}, {5, 4, 0}, {4, 4, 0},
                              {4, 1, 0}, {3, 1, 0}, {3, 4, 0}, {2, 4, 0}, {2, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
  for (std::size_t i = 0; i < teeth.size(); ++i) {
    expect_fills(teeth, 7.0 + 4 * 3.0);
    std::rotate(teeth.begin(), teeth.begin() + 1, teeth.end());
  }
}

TEST(Polygon, hole_may_use_coincident_edges) {
  // The area is 6 x 6 minus a hole of 2 x 2. A cut from (0, 0) to (2, 2) connects both outlines.
  expect_fills({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 0, 0}, {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}},
               32.0);
}

TEST(Polygon, winding_is_kept_in_any_plane) {
  // The notched square in the plane x = 0, clockwise as seen from +x.
  const std::vector<Vec3f> polygon = {{0, 0, 0}, {0, 0, 4}, {0, 4, 4}, {0, 1, 2}, {0, 4, 0}};
  glm::dvec3 sum(0.0);
  for (const Triangle& t : triangulate(polygon)) {
    EXPECT_LE(area_vector(polygon, t).x, 0.0);
    sum += area_vector(polygon, t);
  }
  EXPECT_EQ(sum, glm::dvec3(-10.0, 0.0, 0.0));  // the area, along -x: 16 - 6
}

TEST(Polygon, crossed_polygon_gives_few_triangles) {
  const std::vector<Vec3f> bow = {{0, 0, 0}, {4, 3, 0}, {4, 0, 0}, {0, 4, 0}, {-1, 2, 0}};
  EXPECT_LE(triangulate(bow).size(), 3u);
}

TEST(Polygon, no_area_no_triangles) {
  EXPECT_TRUE(triangulate(std::vector<Vec3f>{{0, 0, 0}, {1, 1, 1}}).empty());
  EXPECT_TRUE(triangulate(std::vector<Vec3f>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}).empty());
}

}  // namespace
}  // namespace lippmann

#include "lippmann/optics/angular_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lippmann {
namespace {

Optics three_views() {
  Optics optics;
  optics.panel = {90, 20, 0.5f};
  optics.model = MultiView{.columns = 3, .rows = 1, .view_cone = radians(30.0f), .distance_mm = 100.0f};
  return optics;
}

// The radical inverses of 0 to 3 in base 3 are 0, 1/3, 2/3 and 1/9, with the ranks 0, 2, 3 and 1. A sample is shifted
// by (rank + 1/2) / 4 - 1/2 views.
TEST(AngularFilter, shifts_follow_radical_inverses) {
  const std::vector<Vec2f> shifts = eye_shifts(three_views(), AngularFilter::kBox, 4);
  ASSERT_EQ(shifts.size(), 4u);
  EXPECT_FLOAT_EQ(shifts[0].x, -0.375f);
  EXPECT_FLOAT_EQ(shifts[1].x, 0.125f);
  EXPECT_FLOAT_EQ(shifts[2].x, 0.375f);
  EXPECT_FLOAT_EQ(shifts[3].x, -0.125f);
  for (const Vec2f shift : shifts) EXPECT_EQ(shift.y, 0.0f);
}

TEST(AngularFilter, nothing_is_spread_without_neighbours_or_filter) {
  Optics optics = three_views();
  EXPECT_EQ(eye_shifts(optics, AngularFilter::kNone, 4), std::vector<Vec2f>{Vec2f(0.0f)});
  optics.model = LenticularSheet{};
  EXPECT_EQ(eye_shifts(optics, AngularFilter::kBox, 4), std::vector<Vec2f>{Vec2f(0.0f)});
  optics.model = MultiView{.columns = 1, .rows = 3, .baseline_mm = 2.0f};
  for (const Vec2f shift : eye_shifts(optics, AngularFilter::kBox, 5)) EXPECT_EQ(shift.x, 0.0f);
}

TEST(AngularFilter, whole_step_is_the_next_eye) {
  Optics grid = three_views();
  grid.model = MultiView{.columns = 3, .rows = 2, .distance_mm = 100.0f, .baseline_mm = 4.0f};
  for (const Optics& optics : {three_views(), grid}) {
    const Ray next = ray_of_pixel(optics, {30.0f + 7.5f, 3.5f});
    const Ray moved = ray_of_pixel(with_eyes_shifted(optics, {1.0f, 0.0f}), {7.5f, 3.5f});
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(moved.direction[axis], next.direction[axis], 1e-6);
    const auto in_plane = [](const Ray& ray) { return ray.origin - ray.direction * (ray.origin.z / ray.direction.z); };
    EXPECT_NEAR(in_plane(moved).x, in_plane(next).x, 1e-4);
    EXPECT_NEAR(in_plane(moved).y, in_plane(next).y, 1e-4);
  }
}

}  // namespace
}  // namespace lippmann

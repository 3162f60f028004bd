#include "view/view_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/optics/viewing.hpp"
#include "view/light_fields.hpp"

namespace lippmann {
namespace {

// A pixel at the offset o from the middle below its lens is seen by an eye with the slope -o / g, where g is the gap.
// View 0 shows the rightmost pixels.
TEST(ViewAxes, slopes_are_those_of_lens_rays) {
  const ViewAxes axes = view_axes(test::small_sheet(), {4, 1});
  EXPECT_EQ(axes.across.count, 4);
  EXPECT_NEAR(axes.across.slope(0), -1.5 * 0.25 / 2.0, 1e-6);
  EXPECT_NEAR(axes.across.slope(3), 1.5 * 0.25 / 2.0, 1e-6);
  EXPECT_NEAR(axes.vergence, 0.01, 1e-9);
  EXPECT_EQ(axes.across.beyond, BeyondZone::kNextLens);
  const Ray ray = ray_of_pixel(test::small_sheet(), {11.5f, 3.0f});  // the last pixel below the third lens
  const double slope = ray.direction.x / ray.direction.z, x = ray.origin.x - slope * ray.origin.z;
  EXPECT_NEAR(slope, axes.across.slope(0) - x * axes.vergence, 1e-6);
}

TEST(ViewAxes, quilt_views_are_equally_spaced_in_angle) {
  Optics optics;
  optics.panel = {64, 48, 0.125f};
  optics.model = MultiView{};
  const ViewAxes axes = view_axes(optics, {48, 1});
  EXPECT_TRUE(axes.across.by_angle);
  EXPECT_NEAR(std::atan(axes.across.slope(10)), radians(40.0f) * (10.5 / 48.0 - 0.5), 1e-6);
}

TEST(ViewAxes, grid_cameras_are_a_baseline_apart) {
  Optics optics;
  optics.panel = {90, 70, 0.125f};
  MultiView views{9, 7};
  views.baseline_mm = 6.0f, views.distance_mm = 300.0f;
  optics.model = views;
  const ViewAxes axes = view_axes(optics, {9, 7});
  EXPECT_NEAR(axes.across.slope(5) - axes.across.slope(4), 6.0 / 300.0, 1e-6);
  EXPECT_NEAR(axes.up.slope(0), -3.0 * 6.0 / 300.0, 1e-6);
  EXPECT_EQ(axes.up.beyond, BeyondZone::kStays);
}

}  // namespace
}  // namespace lippmann

#include "view/disparity_codes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/math.hpp"

namespace lippmann {
namespace {

// Two eyes 10 mm apart at V = 500 mm see a point at z = 100 mm pass z = 0 at places 10 z / (V - z) = 2.5 mm apart: w = 125 mm,
// and their slopes differ by 10 / 500.
TEST(DisparityCodes, disparity_is_what_points_move_by_per_slope) {
  EXPECT_NEAR(disparity_mm(100.0, 1.0 / 500.0, 1.0), 125.0, 1e-9);
  EXPECT_NEAR(disparity_mm(100.0, 1.0 / 500.0, 1.0) * 10.0 / 500.0, 2.5, 1e-9);
  EXPECT_EQ(disparity_mm(-40.0, 0.0, 0.5), -20.0);
  EXPECT_EQ(disparity_mm(-kInfinity, 1.0 / 500.0, 1.0), -500.0);
}

// Near the plane a step of the codes is scale / 32767; at ten scales away 121 times as much.
TEST(DisparityCodes, codes_say_disparities_finely) {
  for (const float z : {0.0f, 0.37f, -2.5f, 55.0f, -300.0f}) {
    Image depth(1, 1, 1);
    depth.data[0] = z;
    const Image8 codes = disparity_codes(disparities_mm(depth, 0.0, 1.0), 60.0);
    const double step = 60.0 / 32767.0 * squared(1.0f + std::abs(z) / 60.0f);
    EXPECT_NEAR(disparity_of_codes(codes.rgb.data(), 60.0), z, step) << z;
  }
}

TEST(DisparityCodes, nothing_and_what_is_no_depth_give_code_0) {
  for (const float z : {-kInfinity, std::nanf(""), kInfinity}) {
    Image depth(1, 1, 1);
    depth.data[0] = z;
    EXPECT_EQ(disparity_codes(disparities_mm(depth, 0.0, 1.0), 60.0).rgb, (std::vector<unsigned char>{0, 0, 0})) << z;
  }
  Image behind_viewer(1, 1, 1);
  behind_viewer.data[0] = 600.0f;
  EXPECT_EQ(disparity_codes(disparities_mm(behind_viewer, 1.0 / 500.0, 1.0), 60.0).rgb, (std::vector<unsigned char>{0, 0, 0}));
}

}  // namespace
}  // namespace lippmann

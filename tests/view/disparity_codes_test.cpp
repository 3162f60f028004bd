#include "view/disparity_codes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/math.hpp"

namespace lippmann {
namespace {

// Two eyes 10 mm apart at V = 500 mm have slopes that differ by 10 / 500. A point at z = 100 mm appears to them 10 z /
// (V - z) = 2.5 mm apart in the plane z = 0. Disparity per slope: w = 2.5 mm / (10 / 500) = 125 mm.
TEST(DisparityCodes, disparity_is_motion_per_slope) {
  EXPECT_NEAR(disparity_mm(100.0, 1.0 / 500.0, 1.0), 125.0, 1e-9);
  EXPECT_NEAR(disparity_mm(100.0, 1.0 / 500.0, 1.0) * 10.0 / 500.0, 2.5, 1e-9);
  EXPECT_EQ(disparity_mm(-40.0, 0.0, 0.5), -20.0);
  EXPECT_EQ(disparity_mm(-kInfinity, 1.0 / 500.0, 1.0), -500.0);
}

// The normalised disparity w / (|w| + 60 mm) is 0, 1/2, -1/2, 10/11 and 0.37 / 60.37 at the test depths.
TEST(DisparityCodes, codes_follow_the_formula) {
  const auto code = [](float z) {
    Image depth(1, 1, 1);
    depth.data[0] = z;
    const Image8 codes = disparity_codes(disparities_mm(depth, 0.0, 1.0), 60.0);
    EXPECT_EQ(codes.rgb[2], 0);
    return codes.rgb[0] * 256 + codes.rgb[1];
  };
  EXPECT_EQ(code(0.0f), 32768);
  EXPECT_EQ(code(60.0f), 49152);
  EXPECT_EQ(code(-60.0f), 16385);
  EXPECT_EQ(code(600.0f), 62556);
  EXPECT_EQ(code(0.37f), 32969);
}

TEST(DisparityCodes, nothing_and_invalid_depths_give_code_0) {
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

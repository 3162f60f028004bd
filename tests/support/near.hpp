#pragma once

#include <gtest/gtest.h>

#include "lippmann/core/math.hpp"

namespace lippmann::test {

inline void expect_near(Vec3f got, Vec3f expected, float tolerance = 1e-5f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], tolerance) << "component " << c;
}

}  // namespace lippmann::test

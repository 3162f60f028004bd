#include "frames/strip_maker.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lippmann {
namespace {

FrameReport strip_of_40_db() {
  FrameReport strip;
  strip.estimated_psnr_db = 40.0, strip.psnr_at_least_db = 37.0, strip.psnr_at_most_db = 43.0;
  return strip;
}

TEST(StripReport, sums_rays_and_time) {
  FrameReport strip;
  strip.seconds = 0.5, strip.cpu_seconds = 1.0, strip.rays.primary = 3;
  const FrameReport frame = report_of_strips({strip, strip}, {16, 8});
  EXPECT_EQ(frame.seconds, 1.0);
  EXPECT_EQ(frame.cpu_seconds, 2.0);
  EXPECT_EQ(frame.rays.primary, 6u);
  EXPECT_FALSE(frame.estimated_psnr_db || frame.psnr_at_least_db || frame.psnr_at_most_db);
}

// Errors of strips are independent, so the interval of two equal strips is narrower by sqrt(2).
TEST(StripReport, interval_narrows_by_the_root_of_the_number) {
  const FrameReport frame = report_of_strips({strip_of_40_db(), strip_of_40_db()}, {16, 16});
  EXPECT_NEAR(frame.estimated_psnr_db.value(), 40.0, 1e-9);
  EXPECT_NEAR(frame.psnr_at_least_db.value(), 40.0 - 3.0 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(frame.psnr_at_most_db.value(), 40.0 + 3.0 / std::sqrt(2.0), 1e-9);
}

// The first strip has 8 of 32 rows. The second strip has no error. The frame's squared error is thus a quarter of the first
// strip's, so the PSNR rises by 10 log10(4) dB.
TEST(StripReport, exact_strips_add_no_error) {
  const FrameReport frame = report_of_strips({strip_of_40_db(), FrameReport{}}, {8, 24});
  const double quarter_db = 10.0 * std::log10(4.0);
  EXPECT_NEAR(frame.estimated_psnr_db.value(), 40.0 + quarter_db, 1e-9);
  EXPECT_NEAR(frame.psnr_at_least_db.value(), 37.0 + quarter_db, 1e-9);
}

TEST(StripReport, lower_bounds_give_a_lower_bound) {
  FrameReport strip;
  strip.psnr_at_least_db = 50.0;
  const FrameReport frame = report_of_strips({strip}, {16});
  EXPECT_NEAR(frame.psnr_at_least_db.value(), 50.0, 1e-9);
  EXPECT_FALSE(frame.estimated_psnr_db || frame.psnr_at_most_db);
}

}  // namespace
}  // namespace lippmann

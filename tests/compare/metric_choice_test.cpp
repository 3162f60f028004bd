#include "compare/metric_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using ::testing::HasSubstr;

TEST(ReadMetrics, names_are_chosen_alone) {
  const MetricChoice choice = read_metrics("psnr,ms-ssim,angular");
  EXPECT_TRUE(choice.slow.ms_ssim && choice.angular);
  EXPECT_FALSE(choice.psnr_y || choice.psnr_yuv || choice.slow.flip || choice.flicker);
}

TEST(ReadMetrics, all_selects_every_metric) {
  const MetricChoice choice = read_metrics("all");
  EXPECT_TRUE(choice.psnr_y && choice.psnr_yuv && choice.slow.ms_ssim && choice.slow.flip);
  EXPECT_TRUE(choice.tries_angular() && choice.tries_flicker());
}

TEST(ReadMetrics, all_requires_only_metrics_that_are_also_named) {
  const MetricChoice choice = read_metrics("all,flicker");
  EXPECT_TRUE(choice.all && choice.flicker);
  EXPECT_FALSE(choice.angular);
}

TEST(ReadMetrics, unknown_names_are_refused_with_the_nearest) {
  EXPECT_THAT(error_message([] { read_metrics("psnr-y,flipp"); }), HasSubstr("did you mean 'flip'?"));
  EXPECT_THAT(error_message([] { read_metrics("flip,"); }), HasSubstr("there is no metric"));
  EXPECT_THAT(error_message([] { read_metrics(""); }), HasSubstr("there is no metric"));
}

}  // namespace
}  // namespace lippmann

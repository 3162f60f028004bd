#include "compare/comparison_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace lippmann {
namespace {

using ::testing::HasSubstr;

Comparison two_frames() {
  PictureMetrics different, same;
  different.mse = {1.0, 2.0, 6.0, 3.0};
  different.rmse = {1.0, 1.5, 2.5, 1.75};
  different.psnr_db = 43.25, different.ssim = 0.5, different.psnr_y_db = 44.0, different.psnr_yuv_db = 42.0,
  different.identical = false;
  same.psnr_db = same.psnr_y_db = same.psnr_yuv_db = std::numeric_limits<double>::infinity();
  same.ssim = std::numeric_limits<double>::quiet_NaN();
  return summarise({{"frame_0000", different}, {"a,\"b\"", same}});
}

TEST(ComparisonJson, has_the_documented_keys_and_nulls) {
  const nlohmann::json json = nlohmann::json::parse(comparison_json(two_frames()));
  EXPECT_EQ(json["frames"].size(), 2u);
  EXPECT_EQ(json["frames"][0]["name"], "frame_0000");
  EXPECT_EQ(json["frames"][0]["mse"]["b"], 6.0);
  EXPECT_EQ(json["frames"][0]["rmse"]["mean"], 1.75);
  EXPECT_EQ(json["frames"][0]["psnr_db"], 43.25);
  EXPECT_TRUE(json["frames"][1]["psnr_db"].is_null());
  EXPECT_TRUE(json["frames"][1]["ssim"].is_null());
  EXPECT_EQ(json["mean"]["mse"]["mean"], 1.5);
  EXPECT_EQ(json["mean"]["psnr_db"], 43.25);
  EXPECT_EQ(json["mean"]["ssim"], 0.5);
  EXPECT_EQ(json["identical"], false);
}

TEST(ComparisonJson, invalid_utf8_name_gives_valid_json) {
  const Comparison comparison = summarise({{"caf\xe9", PictureMetrics{}}});
  EXPECT_TRUE(nlohmann::json::accept(comparison_json(comparison)));
}

TEST(ComparisonCsv, one_line_per_frame_with_quoted_names) {
  EXPECT_EQ(comparison_csv(two_frames()),
            "name,mse_r,mse_g,mse_b,mse_mean,rmse_r,rmse_g,rmse_b,rmse_mean,psnr_db,ssim,psnr_y_db,psnr_yuv_db\n"
            "frame_0000,1,2,6,3,1,1.5,2.5,1.75,43.25,0.5,44,42\n"
            "\"a,\"\"b\"\"\",0,0,0,0,0,0,0,0,,,,\n");
}

TEST(ComparisonTable, ends_with_the_mean) {
  const std::string table = comparison_table(two_frames());
  EXPECT_THAT(table, HasSubstr("frame_0000      1.0000     2.0000     6.0000     3.0000    1.7500   43.2500   0.50000\n"));
  EXPECT_THAT(table, HasSubstr("mean            0.5000     1.0000     3.0000     1.5000    0.8750   43.2500   0.50000\n"));
  EXPECT_THAT(table, ::testing::Not(HasSubstr("identical")));
}

}  // namespace
}  // namespace lippmann

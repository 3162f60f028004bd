// The figures of reuse between frames, on a few frames of one scene: which there are, and what must be so whatever is saved.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using Json = nlohmann::json;

TEST(BenchReuse, json_has_a_row_per_method_and_exact_frames_have_no_error) {
  const TempDir dir;
  const RunResult result =
      run_tool(dir, {"bench", "reuse", "--scene", "primitives", "--frames", "3", "--tachyon-scenes", "nowhere", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = json_of(result.out);
  ASSERT_EQ(report["rows"].size(), 2u);
  EXPECT_EQ(report["rows"][0]["method"], "exact");
  EXPECT_EQ(report["rows"][1]["method"], "forward, 50 dB");
  for (const Json& row : report["rows"]) {
    EXPECT_EQ(row["scene"], "primitives");
    EXPECT_EQ(row["keyframes"], "auto");
    EXPECT_EQ(row["frames"], 3);
    EXPECT_LT(row["saving_total"], 1.0);
    EXPECT_TRUE(row["tachyon_ratio"].is_null());
    for (const char* key : {"saving_in_between", "moving_psnr_db", "blend_psnr_db", "ssim"})
      EXPECT_TRUE(row.contains(key)) << key;
  }
  EXPECT_TRUE(report["rows"][0]["psnr_db"].is_null());
  EXPECT_EQ(report["rows"][0]["ssim"], 1.0);
}

}  // namespace
}  // namespace lippmann::test

// The figures of --denoise: which there are, and that a few samples come nearer to the truth.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using Json = nlohmann::json;

TEST(BenchDenoise, json_has_a_row_per_picture_and_number_of_samples) {
  const TempDir dir;
  const RunResult result =
      run_tool(dir, {"bench", "denoise", "--scene", "teapot", "--quick", "--references", "refs", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json rows = json_of(result.out)["rows"];
  ASSERT_EQ(rows.size(), 6u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]["picture"], i < 3 ? "integral" : "quilt");
    EXPECT_EQ(rows[i]["spp"], 4 << (2 * (i % 3)));
    for (const char* key : {"noisy_psnr_db", "psnr_db", "noisy_flicker", "flicker", "noisy_cpu_seconds", "cpu_seconds"})
      EXPECT_TRUE(rows[i][key].is_number()) << key;
  }
  EXPECT_GT(rows[0]["psnr_db"], rows[0]["noisy_psnr_db"]);
}

}  // namespace
}  // namespace lippmann::test

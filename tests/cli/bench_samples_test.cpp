// What keeping samples could save: the rows, and that stills are refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

TEST(BenchSamples, json_has_a_row_for_gathered_samples_and_one_for_paths) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"bench", "samples", "--quick", "--scene", "turntable", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json rows = json_of(result.out)["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["samples_of"], "gather");
  EXPECT_EQ(rows[1]["samples_of"], "paths");
  for (const nlohmann::json& row : rows) {
    EXPECT_EQ(row["display_moves"], false);
    EXPECT_GT(row["samples"], 5.0);   // the hall
    EXPECT_LT(row["samples"], 95.0);  // the table
    EXPECT_EQ(row["rays"], row["rays_saved"]);
  }
  EXPECT_TRUE(rows[0]["bounce"].is_null());
  EXPECT_LE(rows[0]["samples_8_frames"], rows[0]["samples"]);
}

TEST(BenchSamples, stills_are_refused) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"bench", "samples", "--quick", "--scene", "room-quilt"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("room-quilt is a still"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace lippmann::test

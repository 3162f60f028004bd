// What many lamps cost: which rows there are.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

TEST(BenchLamps, json_has_a_row_per_kind_and_number_of_lamps) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"bench", "lamps", "--quick", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json rows = json_of(result.out)["rows"];
  ASSERT_EQ(rows.size(), 8u);
  const char* kinds[] = {"points", "spots", "balls", "squares"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]["kind"], kinds[i / 2]);
    EXPECT_EQ(rows[i]["lamps"], i % 2 ? 100 : 10);
    EXPECT_GT(rows[i]["cpu_seconds"], 0.0);
    EXPECT_GT(rows[i]["psnr_db"], 10.0);
    EXPECT_GT(rows[i]["cpu_at_equal_psnr"], 0.0);
  }
  EXPECT_EQ(rows[0]["cpu_at_equal_psnr"], 1.0);
}

}  // namespace
}  // namespace lippmann::test

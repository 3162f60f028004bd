// Eye views of the built-in room through its arrays: every row of the figures, and that no eye sees depth inverted.
#include <gtest/gtest.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

TEST(BenchReplay, no_eye_of_25_sees_depth_inverted_and_near_layers_come_nearest_to_direct_views) {
  const TempDir dir;
  const nlohmann::json report = report_of(dir, {"bench", "replay"});
  ASSERT_EQ(report["rows"].size(), 50u);
  EXPECT_EQ(report["passed_checks"], 100);  // the right way round, and the wrong one where the picture is pseudoscopic
  double near = 0.0, beyond = 0.0;
  for (const auto& row : report["rows"]) {
    EXPECT_GT(row["behind_order_db"], 0.0) << row;
    EXPECT_GT(row["front_order_db"], 0.0) << row;
    near += row["quarter_db"].get<double>() / 50, beyond += row["beyond_db"].get<double>() / 50;
  }
  EXPECT_GT(near, beyond + 3.0);
}

}  // namespace
}  // namespace lippmann::test

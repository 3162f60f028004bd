// `lippmann bench` from outside: flags that are refused, JSON, and how it is stopped. Figures are tested in tests/bench.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

TEST(Bench, json_holds_the_machine_and_the_rows) {
  const TempDir dir;
  const nlohmann::json report =
      report_of(dir, {"bench", "light", "--quick", "--scene", "turntable", "--frames", "1", "--references", "references"});
  EXPECT_EQ(report["bench"], "light");
  EXPECT_GT(report["machine"]["threads"], 0);
  EXPECT_EQ(report["rows"].size(), 1u);
}

TEST(Bench, list_names_rows_and_measures_none) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, {"bench", "light", "--list"}).out, testing::HasSubstr("bar-sun"));
}

TEST(Bench, options_of_other_benchmarks_are_refused_at_once) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"bench", "paper", "--quick"}), 2,
                 "--quick: is not an option of bench paper; accepted: --scene");
  expect_refusal(run_tool(dir, {"bench", "png", "--frames", "3"}), 2, "--frames");
  expect_refusal(run_tool(dir, {"bench", "rays", "--csv", "a"}), 2, "--csv");
}

TEST(Bench, interruption_is_one_line_and_an_exit_code) {
  const TempDir dir;
  Subprocess stopped({"sh", "-c", "exec " LIPPMANN_TOOL " bench paper --scene teapot --tachyon-scenes nowhere 2>log"},
                     {dir.path().string(), 0});
  ASSERT_TRUE(appears(dir / "log"));
  while (bytes_of(dir / "log").find("frames 0 to 7") == std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  stopped.signal(SIGINT);
  EXPECT_NE(stopped.wait().exit_code, 0);
  const std::string log = bytes_of(dir / "log");
  EXPECT_THAT(log, testing::EndsWith("lippmann: bench paper: was stopped before its end\n"));
  EXPECT_THAT(log, testing::Not(testing::HasSubstr("map::at")));
}

}  // namespace
}  // namespace lippmann::test

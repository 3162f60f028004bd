// The paper's tables, on a few frames of one scene: which figures there are, and that they agree with each other.
#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST(BenchPaper, json_has_a_row_per_method_and_the_frames_that_it_sums_up) {
  const TempDir dir;
  const RunResult result = run_tool(dir, {"bench", "paper", "--scene", "primitives", "--frames", "4", "--tachyon-scenes",
                                          "nowhere", "--csv", "paper.csv", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = json_of(result.out);
  EXPECT_EQ(report["passed_checks"], 2 + 1 + 1 + 1 + 1);  // key frames of the five runs
  ASSERT_EQ(report["rows"].size(), 5u);
  for (const Json& row : report["rows"]) {
    double psnr = 0.0;
    int frames = 0;
    for (const Json& frame : report["details"]["frames"]) {
      if (frame["method"] != row["method"] || frame["keyframes"] != row["keyframes"]) continue;
      const Json& mse = frame["mse"];
      EXPECT_NEAR((mse["r"].get<double>() + mse["g"].get<double>() + mse["b"].get<double>()) / 3, mse["mean"], 1e-3);
      EXPECT_NEAR(10 * std::log10(255 * 255 / mse["mean"].get<double>()), frame["psnr_db"], 1e-2);
      psnr += frame["psnr_db"].get<double>();
      ++frames;
    }
    EXPECT_EQ(frames, row["keyframes"] == 2 ? 2 : 3);
    EXPECT_NEAR(psnr / frames, row["psnr_db"], 1e-3);
    EXPECT_LT(row["moving_psnr_db"], row["psnr_db"]);
    EXPECT_LT(row["saving_total"], row["saving_in_between"]);
  }
  EXPECT_EQ(report["details"]["styles"].size(), 1u);
  EXPECT_THAT(result.err, HasSubstr("primitives: frames 0 to 3\n"));
  const std::string csv = bytes_of(dir / "paper.csv");
  EXPECT_THAT(csv, testing::StartsWith("scene,keyframes,saving,paper_saving,psnr_db,paper_psnr_db,reproduced\nprimitives,"));
  EXPECT_EQ(lines_of(csv), 2u);
}

TEST(BenchPaper, text_sets_the_papers_figures_beside_ours_and_plots_are_drawn) {
  const TempDir dir;
  const RunResult result = run_tool(
      dir, {"bench", "paper", "--scene", "primitives", "--frames", "2", "--tachyon-scenes", "nowhere", "--plot", "plots"});
  if (result.err.find("gnuplot-nox") != std::string::npos) GTEST_SKIP() << "gnuplot is not installed";
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("mean squared errors"));
  EXPECT_THAT(result.out, HasSubstr("67 %"));  // what table 2 has saved: 1 - 333 / 1024
  EXPECT_GT(bytes_of(dir / "plots/psnr_primitives.png").size(), 1000u);
  EXPECT_GT(bytes_of(dir / "plots/saving.png").size(), 1000u);
}

TEST(BenchPaper, options_of_other_benchmarks_are_refused_at_once) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"bench", "paper", "--quick"}), 2,
                 "--quick: is not an option of bench paper; accepted: --scene");
  expect_refusal(run_tool(dir, {"bench", "png", "--frames", "3"}), 2, "--frames");
  expect_refusal(run_tool(dir, {"bench", "rays", "--csv", "a"}), 2, "--csv");
}

TEST(BenchPaper, a_table_that_cannot_be_written_is_refused_before_anything_is_measured) {
  const TempDir dir;
  std::ofstream(dir / "file") << "in the way";
  const Words bench{"bench", "paper", "--scene", "teapot", "--frames", "2", "--tachyon-scenes", "nowhere", "--csv"};
  expect_refusal(run_tool(dir, bench + Words{"file/table.csv"}), 1, "file: the folder");
  expect_refusal(run_tool(dir, bench + Words{"."}), 1, "is not a regular file");
}

TEST(BenchPaper, interruption_is_one_line_and_an_exit_code) {
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
  EXPECT_THAT(log, Not(HasSubstr("map::at")));
}

TEST(BenchPaper, unknown_scene_is_refused_with_the_known_ones) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"bench", "paper", "--scene", "nothing"}), 2, "gears");
}

}  // namespace
}  // namespace lippmann::test

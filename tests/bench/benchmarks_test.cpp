#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/run_benchmark.hpp"
#include "bench/scenes.hpp"
#include "support/error_message.hpp"
#include "support/file_bytes.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

bench::Request small_request(const std::string& scene, int frames) {
  bench::Request request;
  request.scenes = {scene}, request.frames = frames, request.tachyon_scenes = "nowhere";
  return request;
}

TEST(BenchReuse, json_has_a_row_per_method) {
  const Json rows = run_benchmark("reuse", small_request("primitives", 3)).rows;
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["method"], "exact");
  EXPECT_EQ(rows[1]["method"], "forward, 50 dB");
  for (const Json& row : rows) {
    EXPECT_EQ(row["scene"], "primitives");
    EXPECT_EQ(row["keyframes"], "auto");
    EXPECT_EQ(row["frames"], 3);
    EXPECT_LT(row["saving_total"], 1.0);
    EXPECT_TRUE(row["tachyon_ratio"].is_null());
    for (const char* key : {"saving_in_between", "moving_psnr_db", "blend_psnr_db", "ssim"})
      EXPECT_TRUE(row.contains(key)) << key;
  }
  EXPECT_TRUE(rows[0]["psnr_db"].is_null());
  EXPECT_EQ(rows[0]["ssim"], 1.0);
}

TEST(BenchDenoise, json_has_a_row_per_picture_and_samples) {
  const TempDir dir;
  bench::Request request = quick_request({"teapot"});
  request.references = dir / "references";
  const Json rows = run_benchmark("denoise", request).rows;
  ASSERT_EQ(rows.size(), 6u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]["picture"], i < 3 ? "integral" : "quilt");
    EXPECT_EQ(rows[i]["spp"], 4 << (2 * (i % 3)));
    for (const char* key : {"noisy_psnr_db", "psnr_db", "noisy_flicker", "flicker", "noisy_cpu_seconds", "cpu_seconds"})
      EXPECT_TRUE(rows[i][key].is_number()) << key;
  }
  EXPECT_GT(rows[0]["psnr_db"], rows[0]["noisy_psnr_db"]);
}

TEST(BenchSplats, json_has_a_row_per_number_of_splats) {
  const Json rows = run_benchmark("splats", quick_request({})).rows;
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0]["splats"], 100000);
  EXPECT_GT(rows[0]["cpu_seconds"], 0.0);
  EXPECT_GT(rows[0]["beside_triangles"], 0.0);
}

TEST(BenchLamps, json_has_a_row_per_kind_and_number_of_lamps) {
  const Json rows = run_benchmark("lamps", quick_request({})).rows;
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

TEST(BenchReplay, all_eyes_see_orthoscopic_depth) {
  const bench::Report report = run_benchmark("replay", {});
  ASSERT_EQ(report.rows.size(), 50u);
  // two checks in each of 50 rows
  EXPECT_EQ(report.passed_checks, 100);
  double near = 0.0, beyond = 0.0;
  for (const auto& row : report.rows) {
    EXPECT_GT(row["behind_order_db"], 0.0) << row;
    EXPECT_GT(row["front_order_db"], 0.0) << row;
    near += row["quarter_db"].get<double>() / 50, beyond += row["beyond_db"].get<double>() / 50;
  }
  EXPECT_GT(near, beyond + 3.0);
}

TEST(BenchPaper, json_text_and_plots_are_complete) {
  const TempDir dir;
  const bool draws = std::system("command -v gnuplot > /dev/null") == 0;
  bench::Request request = small_request("primitives", 4);
  if (draws) request.plot = dir / "plots";
  std::string said;
  request.csv = dir / "paper.csv", request.say = [&](std::string_view line) { said += line, said += '\n'; };
  const bench::Report report = run_benchmark("paper", request);
  // Each row has one check per key frame.
  EXPECT_EQ(report.passed_checks, 2 + 1 + 1 + 1 + 1);
  ASSERT_EQ(report.rows.size(), 5u);
  for (const Json& row : report.rows) {
    double psnr = 0.0;
    int frames = 0;
    for (const Json& frame : report.details["frames"]) {
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
  EXPECT_EQ(report.details["styles"].size(), 1u);
  EXPECT_THAT(said, HasSubstr("primitives: frames 0 to 3\n"));
  EXPECT_THAT(report.text, HasSubstr("mean squared errors"));
  EXPECT_THAT(report.text, HasSubstr("67 %"));  // Table 2 of the paper states a saving of 1 - 333 / 1024 = 67 %.
  const std::string csv = file_bytes(dir / "paper.csv");
  EXPECT_THAT(csv, testing::StartsWith("scene,keyframes,saving,paper_saving,psnr_db,paper_psnr_db,reproduced\nprimitives,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
  if (!draws) GTEST_SKIP() << "no plots: gnuplot is not installed";
  EXPECT_GT(file_bytes(dir / "plots/psnr_primitives.png").size(), 1000u);
  EXPECT_GT(file_bytes(dir / "plots/saving.png").size(), 1000u);
}

TEST(BenchPaper, unwritable_tables_are_refused_first) {
  const TempDir dir;
  std::ofstream(dir / "file") << "in the way";
  bench::Request request = small_request("teapot", 2);
  const auto refusal = [&](const std::string& csv) {
    request.csv = csv;
    return error_message([&] { run_benchmark("paper", request); });
  };
  EXPECT_THAT(refusal(dir / "file/table.csv"), HasSubstr("file: the folder"));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("is not a regular file"));
}

TEST(BenchPaper, unknown_scenes_are_refused) {
  EXPECT_THAT(error_message([] { run_benchmark("paper", small_request("nothing", 0)); }), HasSubstr("gears"));
  bench::Request request = small_request("primitives", 2);
  request.scenes.emplace_back("nothing");
  EXPECT_THAT(error_message([&] { run_benchmark("paper", request); }), HasSubstr("there is no animation 'nothing'"));
}

TEST(BenchPaper, missing_tachyon_files_name_the_package) {
  const std::string message = error_message([] { run_benchmark("paper", small_request("smallballs", 0)); });
  EXPECT_THAT(message, HasSubstr("nowhere: has no smallballs.dat, smallballs.cam"));
  EXPECT_THAT(message, HasSubstr("tachyon-doc"));
}

TEST(BenchPaper, missing_tachyon_scenes_warn) {
  std::vector<std::string> warnings;
  Context context;
  context.warn = [&](std::string_view line) { warnings.emplace_back(line); };
  bench::bench_animations(small_request("primitives", 2), context);
  EXPECT_THAT(warnings, testing::IsEmpty());
  bench::bench_animations(small_request("teapot", 2), context);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("nowhere has no teapot.dat, teapot.cam. Install Debian's package tachyon-doc"));
}

}  // namespace
}  // namespace lippmann::test

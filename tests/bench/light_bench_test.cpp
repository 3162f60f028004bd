#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/run_benchmark.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

Json light_rows(const TempDir& dir, bench::Request request) {
  request.references = dir / "references";
  return run_benchmark("light", request).rows;
}

TEST(BenchLight, json_has_a_row_per_scene_with_all_figures) {
  const TempDir dir;
  const Json rows = light_rows(dir, quick_request({"primitives", "room-quilt", "bar-lamp"}));
  ASSERT_EQ(rows.size(), 3u);
  const char* cases[] = {"animation", "still", "hostile"};
  const int frames[] = {3, 1, 3};
  for (std::size_t r = 0; r < 3; ++r) {
    const Json& row = rows[r];
    EXPECT_EQ(row["case"], cases[r]);
    EXPECT_EQ(row["frames"], frames[r]);
    EXPECT_EQ(row["spp"], 16);
    EXPECT_EQ(row["full_spp"], 64);
    for (const char* key : {"cpu_seconds", "psnr_db", "mean_light", "view_flicker"}) {
      EXPECT_TRUE(row[key].is_number()) << key;
      EXPECT_TRUE(row[std::string("full_") + key].is_number()) << key;
    }
    // The values are null if the noise of the small reference pictures hides the error.
    for (const char* key : {"block_psnr_db", "edge_psnr_db"})
      EXPECT_TRUE(row.contains(key) && row.contains(std::string("full_") + key)) << key;
    EXPECT_EQ(row["frame_flicker"].is_number(), frames[r] >= 3);
    const double ratio = row["full_cpu_seconds"].get<double>() / row["cpu_seconds"].get<double>();
    EXPECT_NEAR(row["time_ratio"].get<double>(), ratio, 0.02 * ratio);
    EXPECT_NEAR(row["saving_total"].get<double>(), 1.0 - 1.0 / ratio, 0.01);
  }
}

TEST(BenchLight, rows_are_measured_in_other_views) {
  const TempDir dir;
  bench::Request request = quick_request({"gloss"}, 1);
  request.views = "4x2", request.view_pixels = 16;
  const Json row = light_rows(dir, request)[0];
  EXPECT_EQ(row["width"], 64);
  EXPECT_EQ(row["height"], 32);
  request.views = "0x3";
  EXPECT_THAT(error_message([&] { light_rows(dir, request); }), HasSubstr("--views"));
}

TEST(BenchLight, valid_references_are_reused) {
  const TempDir dir;
  bench::Request scene = quick_request({"primitives"}, 2);
  const Json first = light_rows(dir, scene)[0], second = light_rows(dir, scene)[0];
  EXPECT_EQ(first["references_rendered"], 4);
  EXPECT_EQ(second["references_kept"], 4);
  EXPECT_EQ(second["references_rendered"], 0);
  EXPECT_EQ(second["psnr_db"], first["psnr_db"]);

  for (const auto& entry : std::filesystem::directory_iterator(dir / "references")) {
    std::ofstream(entry.path()) << "not a picture";
    break;
  }
  const Json repaired = light_rows(dir, scene)[0];
  EXPECT_EQ(repaired["references_rendered"], 1);
  EXPECT_EQ(repaired["psnr_db"], first["psnr_db"]);

  scene.reference_spp = 32;
  EXPECT_EQ(light_rows(dir, scene)[0]["references_rendered"], 4);
}

TEST(BenchLight, pictures_of_every_frame_are_written) {
  const TempDir dir;
  bench::Request request = quick_request({"bar-lamp"}, 1);
  request.pictures = dir / "pictures";
  light_rows(dir, request);
  for (const char* what : {"reference", "denoised", "full", "error"})
    EXPECT_TRUE(std::filesystem::exists(dir / "pictures" / (std::string("bar-lamp_0005_") + what + ".png"))) << what;
}

TEST(BenchLight, unknown_scene_is_refused) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] { light_rows(dir, quick_request({"teapott"})); }), HasSubstr("teapot"));
}

TEST(BenchLight, list_names_all_rows_and_measures_none) {
  bench::Request request;
  request.list = true;
  const bench::Report report = run_benchmark("light", request);
  EXPECT_TRUE(report.rows.empty());
  for (const char* row : {"teapot", "tree-quilt", "bar-sun", "large"}) EXPECT_THAT(report.text, HasSubstr(row));
}

TEST(BenchEstimates, counts_of_intervals_are_consistent) {
  const TempDir dir;
  bench::Request request = quick_request({"flash", "primitives"}, 2);
  request.references = dir / "references";
  const bench::Report report = run_benchmark("estimates", request);
  ASSERT_EQ(report.rows.size(), 2u);
  int frames = 0, contain = 0;
  for (const Json& row : report.rows) {
    EXPECT_EQ(row["frames"], 2 * 2) << "two frames with two seeds";
    EXPECT_EQ(row["contain_truth"].get<int>() + row["too_low"].get<int>() + row["too_high"].get<int>(), row["frames"]);
    EXPECT_LE(row["without_upper_bound"], row["frames"]);
    if (row["mean_width_db"].is_number()) {
      EXPECT_GT(row["mean_width_db"], 0.0);
    }
    frames += row["frames"].get<int>(), contain += row["contain_truth"].get<int>();
  }
  EXPECT_EQ(report.details["frames"], frames);
  EXPECT_NEAR(report.details["share"].get<double>(), static_cast<double>(contain) / frames, 1e-3);
  EXPECT_THAT(report.text, HasSubstr("intervals contain the true PSNR"));
}

}  // namespace
}  // namespace lippmann::test

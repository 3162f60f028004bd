// The figures of path-traced light with reuse, on a few small frames: what must be so whatever is saved.
#include <fmt/core.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/run_benchmark.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

using Json = nlohmann::ordered_json;

Json light_rows(const TempDir& dir, bench::Request request) {
  request.references = dir / "references";
  return run_benchmark("light", request).rows;
}

TEST(BenchLight, json_has_a_row_per_scene_with_all_figures) {
  const TempDir dir;
  const Json rows = light_rows(dir, quick_request({"primitives", "room-quilt"}, 3));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["case"], "animation");
  EXPECT_EQ(rows[0]["frames"], 3);
  EXPECT_TRUE(rows[0]["bar"].is_null());
  EXPECT_EQ(rows[1]["scene"], "room");
  EXPECT_EQ(rows[1]["bar"]["saving_total"], 0.9);
  EXPECT_EQ(rows[1]["case"], "still quilt");
  EXPECT_EQ(rows[1]["frames"], 1);
  EXPECT_TRUE(rows[1]["frame_flicker"].is_null());
  for (const Json& row : rows) {
    for (const char* key : {"time_ratio", "saving_total", "psnr_db", "full_psnr_db", "equal_time_gain_db", "view_flicker"})
      EXPECT_TRUE(row[key].is_number()) << key;
    EXPECT_GT(row["full_rays"], 0);
    EXPECT_GT(row["full_view_flicker"], 0.0);  // noise flickers more than none
  }
  EXPECT_GT(rows[0]["full_frame_flicker"], 0.0);
}

TEST(BenchLight, rows_are_measured_in_other_views) {
  const TempDir dir;
  bench::Request request = quick_request({"gloss"}, 1);
  request.views = "4x2", request.view_pixels = 16;
  const Json row = light_rows(dir, request)[0];
  EXPECT_EQ(row["width"], 64);
  EXPECT_EQ(row["height"], 32);
  request.views = "0x3";
  EXPECT_THAT(error_message([&] { light_rows(dir, request); }), testing::HasSubstr("--views"));
}

// Both sides trace the same paths as in the noisy row: without noise, they are nearer to the same reference.
TEST(BenchLight, both_sides_are_denoised_where_that_is_asked_for) {
  const TempDir dir;
  bench::Request scene = quick_request({"flash"}, 2);
  const Json noisy = light_rows(dir, scene)[0];
  scene.denoise = true;
  const Json denoised = light_rows(dir, scene)[0];
  EXPECT_EQ(denoised["references_kept"], noisy["references_rendered"]);
  EXPECT_GT(denoised["full_psnr_db"], noisy["full_psnr_db"]);
  const auto with_reuse = [](const Json& row) { return row["full_psnr_db"].get<double>() + row["gain_db"].get<double>(); };
  EXPECT_GT(with_reuse(denoised), with_reuse(noisy));
}

TEST(BenchLight, full_render_with_more_samples_is_nearer_to_the_reference) {
  const TempDir dir;
  const Json rows = light_rows(dir, quick_request({"primitives"}, 1));
  const Json& by_spp = rows[0]["full_by_spp"];
  ASSERT_GE(by_spp.size(), 2u);
  for (std::size_t i = 1; i < by_spp.size(); ++i) {
    EXPECT_GT(by_spp[i]["spp"], by_spp[i - 1]["spp"]);
    EXPECT_GT(by_spp[i]["psnr_db"], by_spp[i - 1]["psnr_db"]);
  }
}

TEST(BenchLight, kept_references_serve_again_and_damaged_or_other_ones_do_not) {
  const TempDir dir;
  bench::Request scene = quick_request({"primitives"}, 2);
  const Json first = light_rows(dir, scene)[0], second = light_rows(dir, scene)[0];
  EXPECT_EQ(first["references_rendered"], 4);  // two halves for each of two frames
  EXPECT_EQ(second["references_kept"], 4);
  EXPECT_EQ(second["references_rendered"], 0);
  EXPECT_EQ(second["full_psnr_db"], first["full_psnr_db"]);

  for (const auto& entry : std::filesystem::directory_iterator(dir / "references"))
    if (entry.path().filename().string().starts_with("primitives_0001")) std::ofstream(entry.path()) << "not a picture";
  const Json mended = light_rows(dir, scene)[0];
  EXPECT_EQ(mended["references_rendered"], 2);  // both halves of the frame
  EXPECT_EQ(mended["full_psnr_db"], first["full_psnr_db"]);

  scene.reference_spp = 32;
  EXPECT_EQ(light_rows(dir, scene)[0]["references_rendered"], 4);
}

TEST(BenchLight, unknown_scene_is_refused) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] { light_rows(dir, quick_request({"teapott"})); }), testing::HasSubstr("teapot"));
}

TEST(BenchLight, hostile_row_has_its_figures_and_bars) {
  const TempDir dir;
  bench::Request request = quick_request({"bar-lamp"});
  request.pictures = dir / "pictures";
  const Json row = light_rows(dir, request)[0];
  EXPECT_EQ(row["row"], "bar-lamp");
  EXPECT_EQ(row["frames"], 3);
  EXPECT_EQ(row["compared_frames"], 3);
  EXPECT_TRUE(row["equal_time_psnr_db"].is_null());
  EXPECT_EQ(row["bar"]["block_gain_db"], -3.0);
  for (const char* key : {"block_psnr_db", "full_block_psnr_db", "worst_psnr_db", "worst_block_psnr_db"})
    EXPECT_TRUE(row[key].is_number()) << key;
  EXPECT_GT(row["full_block_psnr_db"], row["full_psnr_db"]);  // noise is weaker in means
  EXPECT_NEAR(row["full_mean_light"].get<double>(), 1.0, 0.05);
  for (const char* what : {"reference", "full", "reuse", "error", "block_error"})
    EXPECT_TRUE(std::filesystem::exists(dir / "pictures" / (std::string("bar-lamp_0002_") + what + ".png"))) << what;
}

TEST(BenchSeeds, rows_are_rendered_with_other_random_numbers_against_the_same_references) {
  const TempDir dir;
  bench::Request request = quick_request({"turntable"});
  request.references = dir / "references", request.seeds = 2;
  const bench::Report report = run_benchmark("seeds", request);
  const Json& rows = report.rows;
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NE(rows[0]["seed"], rows[1]["seed"]);
  EXPECT_NE(rows[0]["psnr_db"], rows[1]["psnr_db"]);
  EXPECT_NE(rows[0]["rays"], rows[1]["rays"]);
  EXPECT_NEAR(rows[0]["mean_light"].get<double>(), rows[1]["mean_light"].get<double>(), 0.05);
  EXPECT_THAT(report.text, testing::HasSubstr("turntable"));
  const auto figure = [&](int run, const char* key) { return rows[static_cast<std::size_t>(run)][key].get<double>(); };
  const auto squared = [&](int run) { return std::pow(10.0, -0.1 * figure(run, "psnr_db")); };
  const double mean = -10.0 * std::log10(0.5 * (squared(0) + squared(1)));
  const double worst = std::min(figure(0, "worst_psnr_db"), figure(1, "worst_psnr_db"));
  EXPECT_THAT(report.text, testing::HasSubstr(fmt::format(" {:.2f} ({:.2f})", mean, worst)));
  request.seeds = 1;
  EXPECT_EQ(run_benchmark("seeds", request).rows[0]["psnr_db"], rows[0]["psnr_db"]);
}

TEST(BenchEstimates, tells_of_every_frame_how_far_its_psnr_is_from_what_is_told) {
  const TempDir dir;
  bench::Request request = quick_request({"flash"});
  request.references = dir / "references";
  const Json row = run_benchmark("estimates", request).rows[0];
  EXPECT_EQ(row["width"], 72);
  EXPECT_EQ(row["frames"], 3);
  ASSERT_EQ(row["excess_db_by_frame"].size(), 3u);
  double most = 0.0, sum = 0.0;
  int close = 0;
  for (const Json& excess : row["excess_db_by_frame"]) {
    most = std::max(most, std::abs(excess.get<double>())), sum += excess.get<double>();
    close += std::abs(excess.get<double>()) <= 0.5 ? 1 : 0;
  }
  EXPECT_NEAR(row["largest_error_db"].get<double>(), most, 1e-3);
  EXPECT_NEAR(row["mean_excess_db"].get<double>(), sum / 3.0, 1e-3);
  EXPECT_EQ(row["close_frames"], close);
  EXPECT_GE(row["bounds_held"], 0);
  EXPECT_LE(row["bounds_held"], 3);
  EXPECT_LT(most, 10.0);
}

TEST(BenchLight, list_names_all_rows_and_measures_none) {
  bench::Request request;
  request.list = true;
  const std::string text = run_benchmark("light", request).text;
  for (const char* row : {"teapot", "tree-quilt", "bar-sun", "large"}) EXPECT_THAT(text, testing::HasSubstr(row));
}

}  // namespace
}  // namespace lippmann::test

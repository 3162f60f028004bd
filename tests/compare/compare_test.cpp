#include "compare/compare.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

#include "compare/plot.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/read_image.hpp"
#include "support/command.hpp"
#include "support/error_message.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"
#include "video/video_writer.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::smooth_codes;
using test::TempDir;
using ::testing::AllOf;
using ::testing::HasSubstr;

fs::path make_folder(const fs::path& folder, int count, double phase = 0.0) {
  fs::create_directories(folder);
  for (int i = 0; i < count; ++i)
    write_png(folder / ("frame_000" + std::to_string(i) + ".png"), smooth_codes(32, 24, 0.2 * i + phase));
  return folder;
}

Comparison compare_quietly(const fs::path& reference, const fs::path& test, int threads = 2,
                           const std::optional<std::vector<int>>& wanted = {}) {
  Context context;
  context.threads = threads;
  return compare(reference, test, context, {.frames = wanted});
}

TEST(Compare, two_pictures_give_one_frame) {
  const TempDir dir;
  write_png(dir / "a.png", smooth_codes(32, 24));
  write_png(dir / "b.png", smooth_codes(32, 24, 0.1));
  const Comparison result = compare_quietly(dir / "a.png", dir / "b.png");
  const PictureMetrics expected = measure_difference(smooth_codes(32, 24), smooth_codes(32, 24, 0.1));
  ASSERT_EQ(result.frames.size(), 1u);
  EXPECT_EQ(result.frames[0].name, "a");
  EXPECT_EQ(result.frames[0].metrics.mse.mean, expected.mse.mean);
  EXPECT_EQ(result.mean_psnr_db, expected.psnr_db);
  EXPECT_EQ(result.mean_ssim, expected.ssim);
  EXPECT_FALSE(result.identical);
}

TEST(Compare, folders_are_matched_by_name) {
  const TempDir dir;
  make_folder(dir / "a", 7);
  make_folder(dir / "b", 7, 0.05);
  const Comparison one = compare_quietly(dir / "a", dir / "b", 1), three = compare_quietly(dir / "a", dir / "b", 3);
  ASSERT_EQ(one.frames.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(one.frames[i].name, "frame_000" + std::to_string(i));
    const Image8 a = smooth_codes(32, 24, 0.2 * static_cast<double>(i)),
                 b = smooth_codes(32, 24, 0.2 * static_cast<double>(i) + 0.05);
    EXPECT_EQ(one.frames[i].metrics.mse.mean, measure_difference(a, b).mse.mean);
    EXPECT_EQ(three.frames[i].metrics.psnr_db, one.frames[i].metrics.psnr_db);
  }
  EXPECT_EQ(three.mean_psnr_db, one.mean_psnr_db);
  EXPECT_EQ(three.mean_ssim, one.mean_ssim);
}

TEST(Compare, other_pictures_beside_frames_are_left_out) {
  const TempDir dir;
  make_folder(dir / "a", 2);
  make_folder(dir / "b", 2);
  write_png(dir / "b/aov_0000.png", smooth_codes(8, 8));
  write_png(dir / "b/.frame_0002.tmp-1.png", smooth_codes(8, 8));
  std::ofstream(dir / "b/report.json") << "{}";
  const Comparison result = compare_quietly(dir / "a", dir / "b");
  EXPECT_EQ(result.frames.size(), 2u);
  EXPECT_TRUE(result.identical);
}

TEST(Compare, frames_of_other_extension_match_by_name) {
  const TempDir dir;
  make_folder(dir / "a", 1);
  fs::create_directories(dir / "b");
  Image film(32, 24, 3);
  const ExrLayer layers[] = {film_layer(film)};
  write_exr(dir / "b/frame_0000.exr", layers);
  EXPECT_EQ(compare_quietly(dir / "a", dir / "b").frames.size(), 1u);
}

TEST(Compare, folder_equals_its_lossless_video) {
  const TempDir dir;
  fs::create_directories(dir / "a");
  VideoWriter video(dir / "a.mkv");
  for (int i = 0; i < 12; ++i) {
    write_png(dir / "a" / ("picture_" + std::to_string(i) + ".png"), smooth_codes(32, 24, 0.2 * i));
    video.add_frame(smooth_codes(32, 24, 0.2 * i));
  }
  video.finish();
  const Comparison result = compare_quietly(dir / "a.mkv", dir / "a");
  ASSERT_EQ(result.frames.size(), 12u);
  EXPECT_TRUE(result.identical);
  EXPECT_EQ(result.frames[10].name, "picture_10") << "files have better names than video frames";
  EXPECT_FALSE(result.mean_psnr_db.has_value());
}

TEST(Compare, missing_frame_is_named) {
  const TempDir dir;
  make_folder(dir / "four", 4);
  make_folder(dir / "three", 3);
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "four", dir / "three"); }),
              AllOf(HasSubstr("three: has no frame frame_0003"), HasSubstr("(3 frames), unlike"), HasSubstr("(4 frames)")));
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "three", dir / "four"); }),
              HasSubstr("three: has no frame frame_0003"));
}

TEST(Compare, video_with_fewer_frames_is_named) {
  const TempDir dir;
  make_folder(dir / "a", 4);
  VideoWriter video(dir / "a.mkv");
  for (int i = 0; i < 3; ++i) video.add_frame(smooth_codes(32, 24));
  video.finish();
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "a", dir / "a.mkv"); }), HasSubstr("a.mkv: ends after 3 frames"));
}

TEST(Compare, video_frames_match_numbered_files) {
  const TempDir dir;
  fs::create_directories(dir / "a");
  VideoWriter video(dir / "a.mkv");
  for (int i = 0; i < 6; ++i) video.add_frame(smooth_codes(32, 24, 0.2 * i));
  video.finish();
  for (const int i : {1, 4}) write_png(dir / "a" / fmt::format("frame_{:04}_qs8x6a0.75.png", i), smooth_codes(32, 24, 0.2 * i));
  const Comparison result = compare_quietly(dir / "a.mkv", dir / "a", 2, std::vector{1, 4});
  ASSERT_EQ(result.frames.size(), 2u);
  EXPECT_TRUE(result.identical);
  EXPECT_THAT(error_message([&] {
                compare_quietly(dir / "a.mkv", dir / "a.mkv", 2, std::vector{1, 7});
              }),
              HasSubstr("a.mkv: has no frame 7, which `frames` requests"));
}

TEST(Compare, ignored_channels_and_samples_give_warnings) {
  const TempDir dir;
  Image film(2, 2, 3);
  film.data[1] = std::numeric_limits<float>::quiet_NaN();
  film.data[5] = std::numeric_limits<float>::infinity();
  const Image one(2, 2, 1);
  write_exr(dir / "a.exr", std::array{film_layer(film), alpha_layer(one), depth_layer(one)});
  write_exr(dir / "b.exr", std::array{film_layer(Image(2, 2, 3))});
  Context context;
  context.threads = 1;
  std::vector<std::string> warnings;
  context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  compare(dir / "a.exr", dir / "b.exr", context);
  EXPECT_THAT(warnings, ::testing::ElementsAre(HasSubstr("a.exr: alpha is not compared."),
                                               HasSubstr("a.exr: only its colours are compared, not 'Z'."),
                                               HasSubstr("a.exr: 2 of its 12 samples are NaN or infinite")));
}

TEST(Compare, frames_of_different_sizes_are_named) {
  const TempDir dir;
  write_png(dir / "a.png", smooth_codes(32, 24));
  write_png(dir / "b.png", smooth_codes(32, 25));
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "a.png", dir / "b.png"); }),
              AllOf(HasSubstr("b.png"), HasSubstr("32 x 25 pixels, but the reference has 32 x 24")));
}

TEST(Compare, incomparable_inputs_are_errors) {
  const TempDir dir;
  make_folder(dir / "a", 1);
  fs::create_directories(dir / "empty");
  fs::create_directories(dir / "twice");
  write_png(dir / "twice/frame_0000.png", smooth_codes(8, 8));
  write_png(dir / "twice/frame_0000.tga.png", smooth_codes(8, 8));
  fs::rename(dir / "twice/frame_0000.tga.png", dir / "twice/frame_0000.tga");
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "a", dir / "none"); }),
              HasSubstr("none: there is no such file or folder"));
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "a", dir / "empty"); }), HasSubstr("has no pictures"));
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "a", dir / "a/frame_0000.png"); }),
              HasSubstr("is a picture, but the reference is a folder"));
  EXPECT_THAT(error_message([&] { compare_quietly(dir / "a", dir / "twice"); }), HasSubstr("two pictures for one frame"));
}

TEST(Compare, cancelled_stops) {
  const TempDir dir;
  make_folder(dir / "a", 3);
  Context context;
  context.cancelled = true;
  EXPECT_TRUE(compare(dir / "a", dir / "a", context).frames.empty());
}

TEST(Summarise, mean_psnr_ignores_identical_frames) {
  PictureMetrics same, thirty, forty;
  same.psnr_db = std::numeric_limits<double>::infinity();
  thirty.psnr_db = 30.0, thirty.identical = false, thirty.ssim = 0.8, thirty.mse.mean = 6.0;
  forty.psnr_db = 40.0, forty.identical = false, forty.ssim = std::nan(""), forty.mse.mean = 3.0;
  const Comparison result = summarise({{"a", same}, {"b", thirty}, {"c", forty}});
  EXPECT_EQ(result.mean_psnr_db, 35.0);
  EXPECT_EQ(result.mean_ssim, 0.9);
  EXPECT_EQ(result.mean_mse.mean, 3.0);
  EXPECT_FALSE(result.identical);
}

TEST(PlotPsnr, draws_a_picture) {
  if (!test::program_exists("gnuplot")) GTEST_SKIP() << "gnuplot (package gnuplot-nox) is not installed";
  const TempDir dir;
  make_folder(dir / "a", 5);
  make_folder(dir / "b", 5, 0.05);
  plot_psnr(compare_quietly(dir / "a", dir / "b"), dir / "it's a plot.png");
  EXPECT_EQ(read_image8(dir / "it's a plot.png").width, 960);
  EXPECT_EQ(std::distance(fs::directory_iterator(dir.path()), {}), 3) << "two folders and the plot";
}

TEST(PlotPsnr, missing_gnuplot_is_an_error) {
  const TempDir dir;
  make_folder(dir / "a", 1);
  make_folder(dir / "b", 1, 0.05);
  const Comparison comparison = compare_quietly(dir / "a", dir / "b");
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const std::string message = error_message([&] { plot_psnr(comparison, dir / "plot.png"); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(message, HasSubstr("gnuplot-nox"));
  EXPECT_FALSE(fs::exists(dir / "plot.png"));
}

TEST(PlotPsnr, identical_frames_have_no_plot) {
  const TempDir dir;
  make_folder(dir / "a", 2);
  EXPECT_THAT(error_message([&] { plot_psnr(compare_quietly(dir / "a", dir / "a"), dir / "plot.png"); }),
              HasSubstr("nothing to plot"));
}

}  // namespace
}  // namespace lippmann

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "compare/compare.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"
#include "support/error_message.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::smooth_codes;
using test::TempDir;
using ::testing::HasSubstr;

constexpr int kWidth = 20, kHeight = 12;

Image8 brighter(Image8 picture, int by) {
  for (unsigned char& code : picture.rgb) code = static_cast<unsigned char>(code + by);
  return picture;
}

void write_motion(const fs::path& path) {
  const Image motion(kWidth, kHeight, 2);
  write_exr(path, std::array{ExrLayer{"motion", &motion, {"X", "Y"}, ExrSample::kFloat}});
}

/// Writes frames of two views without motion. View v of frame f is errors[f][v] codes brighter than smooth_codes.
fs::path make_frames(const fs::path& folder, const std::vector<std::array<int, 2>>& errors) {
  for (std::size_t f = 0; f < errors.size(); ++f) {
    const fs::path frame = folder / fmt::format("frame_{:04}", f);
    fs::create_directories(frame);
    for (std::size_t v = 0; v < 2; ++v) {
      write_png(frame / fmt::format("view_{:03}.png", v), brighter(smooth_codes(kWidth, kHeight), errors[f][v]));
      write_motion(frame / fmt::format("aov_{:03}.exr", v));
    }
  }
  return folder;
}

Comparison compared(const fs::path& reference, const fs::path& test, const CompareParams& params) {
  Context context;
  context.threads = 2;
  return compare(reference, test, context, params);
}

TEST(CompareViews, every_view_is_a_row) {
  const TempDir dir;
  make_frames(dir / "a", {{0, 0}, {0, 0}});
  make_frames(dir / "b", {{1, 2}, {3, 4}});
  const Comparison result = compared(dir / "a", dir / "b", {.per_view = true});
  ASSERT_EQ(result.frames.size(), 4u);
  EXPECT_EQ(result.frames[1].name, "frame_0000/view_001");
  EXPECT_EQ(result.frames[3].metrics.mse.mean, 16.0);
  EXPECT_TRUE(result.consistency.empty());
}

TEST(CompareViews, consistency_has_views_and_frames) {
  const TempDir dir;
  make_frames(dir / "a", {{0, 0}, {0, 0}});
  make_frames(dir / "b", {{1, 2}, {4, 5}});
  const Comparison result = compared(dir / "a", dir / "b", {.choice = {.angular = true, .flicker = true}});
  ASSERT_EQ(result.consistency.size(), 2u);
  EXPECT_NEAR(*result.consistency[0].angular_psnr_db, psnr_db(1.0), 1e-12);
  EXPECT_FALSE(result.consistency[0].flicker) << "there is no frame before";
  EXPECT_NEAR(*result.consistency[1].flicker, 3.0, 1e-12);
}

TEST(CompareViews, quilt_equals_a_folder_of_its_views) {
  const TempDir dir;
  make_frames(dir / "a", {{0, 7}});
  const Image8 left = smooth_codes(kWidth, kHeight), right = brighter(left, 9);
  Image8 quilt{2 * kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y)
    for (const Image8* view : {&left, &right})
      quilt.rgb.insert(quilt.rgb.end(), view->rgb.begin() + 3 * kWidth * y, view->rgb.begin() + 3 * kWidth * (y + 1));
  write_png(dir / "quilt_qs2x1a1.67.png", quilt);
  const Comparison result = compared(dir / "a/frame_0000", dir / "quilt_qs2x1a1.67.png", {.per_view = true});
  ASSERT_EQ(result.frames.size(), 2u);
  EXPECT_TRUE(result.frames[0].metrics.identical);
  EXPECT_EQ(result.frames[1].metrics.mse.mean, 4.0);
}

TEST(CompareViews, single_pictures_flicker_too) {
  const TempDir dir;
  for (const char* folder : {"a", "b"}) fs::create_directories(dir / folder);
  for (int f = 0; f < 2; ++f) {
    write_png(dir / fmt::format("a/frame_{:04}.png", f), smooth_codes(kWidth, kHeight));
    write_png(dir / fmt::format("b/frame_{:04}.png", f), brighter(smooth_codes(kWidth, kHeight), 2 * f));
    write_motion(dir / fmt::format("a/aov_{:04}.exr", f));
  }
  const CompareParams params{.choice = {.flicker = true}, .hints = {.views = ViewGrid{1, 1}}};
  EXPECT_NEAR(*compared(dir / "a", dir / "b", params).consistency.at(1).flicker, 2.0, 1e-12);
}

TEST(CompareViews, missing_motion_and_gaps_are_refused) {
  const TempDir dir;
  make_frames(dir / "a", {{0, 0}, {0, 0}, {0, 0}});
  const CompareParams flicker{.choice = {.flicker = true}};
  CompareParams gaps = flicker;
  gaps.frames = {0, 2};
  EXPECT_THAT(error_message([&] { compared(dir / "a", dir / "a", gaps); }), HasSubstr("consecutive frames"));
  fs::remove(dir / "a/frame_0001/aov_001.exr");
  EXPECT_THAT(error_message([&] { compared(dir / "a", dir / "a", flicker); }), HasSubstr("no motion layer"));
  make_frames(dir / "two", {{0, 0}, {0, 0}});
  EXPECT_THAT(error_message([&] { compared(dir / "a", dir / "two", {.per_view = true}); }), HasSubstr("has 2 light fields"));
  fs::remove(dir / "two/frame_0000/view_001.png");
  EXPECT_THAT(error_message([&] { compared(dir / "a/frame_0000", dir / "two/frame_0000", {.per_view = true}); }),
              HasSubstr("views"));
}

}  // namespace
}  // namespace lippmann

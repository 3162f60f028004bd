#include <fmt/core.h>
#include <gmock/gmock.h>

#include <array>
#include <fstream>

#include "cli/tool.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Prints : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(dir_ / "in");
    for (int view = 0; view < 4; ++view) {
      Image8 image{24, 16, {}};
      for (int i = 0; i < 24 * 16; ++i) image.rgb.insert(image.rgb.end(), {static_cast<unsigned char>(60 * view), 9, 200});
      write_picture(dir_ / ("in/view_00" + std::to_string(view) + ".png"), image);
    }
  }

  Image8 picture(const std::string& name) { return std::get<Image8>(read_picture(dir_ / name)); }

  TempDir dir_;
  const Words sheet_{"--lpi", "20", "--dpi", "80", "--paper", "200x100px"};
};

TEST_F(Prints, sheet_sets_size_and_resolution) {
  const RunResult run = run_tool(dir_, Words{"convert", "in", "out.png"} + sheet_);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("4.000 pixels below each lens, a print pitch of 20.000 lpi"));
  EXPECT_THAT(run.out, HasSubstr("cropped from 24x16 to 24x12, resized to 50x100"));
  const Image8 print = picture("out.png");
  ASSERT_EQ(print.width, 200);
  for (int x = 0; x < 200; ++x) EXPECT_EQ(print.rgb[3 * static_cast<std::size_t>(x)], 60 * (3 - x % 4)) << x;
  EXPECT_THAT(bytes_of(dir_ / "out.png"), HasSubstr(std::string("pHYs\0\0\x0c\x4e\0\0\x0c\x4e\x01", 13))) << "3150 per metre";
  expect_done(dir_, Words{"convert", "in", "out.tiff"} + sheet_);
  EXPECT_EQ(picture("out.tiff").rgb, print.rgb);
}

TEST_F(Prints, frames_of_a_video_are_views) {
  for (int view = 0; view < 4; ++view) {
    fs::create_directories(dir_ / "frames");
    fs::copy_file(dir_ / fmt::format("in/view_{:03}.png", view), dir_ / fmt::format("frames/frame_{:04}.png", view));
  }
  expect_done(dir_, {"encode", "frames", "clip.mkv"});
  expect_done(dir_, Words{"convert", "in", "folder.png"} + sheet_);
  expect_done(dir_, Words{"convert", "clip.mkv", "video.png"} + sheet_);
  EXPECT_EQ(picture("video.png").rgb, picture("folder.png").rgb) << "FFV1 keeps all codes";
  expect_done(dir_, {"convert", "clip.mkv", "two", "--to", "views", "--views", "2x1"});
  EXPECT_EQ(picture("two/view_000.png").rgb[0], 0);
  EXPECT_EQ(picture("two/view_001.png").rgb[0], 180) << "the last frame of four";
  EXPECT_FALSE(fs::exists(dir_ / "two/view_002.png"));
  expect_refusal(run_tool(dir_, {"convert", "clip.mkv", "five", "--to", "views", "--views", "5x1"}), 2, "has only 4 frames");
  expect_refusal(run_tool(dir_, {"convert", "clip.mkv", "rows", "--to", "views", "--views", "2x2"}), 2, "one row of views");
}

TEST_F(Prints, flip_print_starts_on_the_left) {
  expect_done(dir_, Words{"convert", "in", "out.png", "--flip", "--shares", "2,1,0.4,0.6"} + sheet_);
  const Image8 print = picture("out.png");
  // Frame that each of the four pixels below a lens shows. Frame 2 covers 0.75 to 0.85 of the lens, which is between
  // the pixel centres at 5/8 and 7/8.
  constexpr std::array<int, 4> kFrames{0, 0, 1, 3};
  for (std::size_t x = 0; x < 200; ++x) EXPECT_EQ(print.rgb[3 * x], 60 * kFrames[x % 4]) << x;
}

TEST_F(Prints, default_is_the_displays_own_picture) {
  expect_done(dir_, {"convert", "in", "panel.png", "--display", "portrait"});
  EXPECT_EQ(picture("panel.png").width, 1536);
  expect_done(dir_, {"convert", "in", "q.png", "--to", "quilt", "--display", "portrait"});
  EXPECT_EQ(picture("q_qs8x6a0.75.png").width, 3360);
}

TEST_F(Prints, renders_and_jobs_take_the_sheet) {
  expect_done(dir_, Words{"render", "small-balls", "--frames", "0", "-o", "r"} + sheet_);
  EXPECT_EQ(picture("r/frame_0000.png").width, 200);
  EXPECT_THAT(bytes_of(dir_ / "r/job.toml"), HasSubstr("lpi=20 dpi=80 paper=200x100px"));
  expect_done(dir_, {"render", "r/job.toml", "-o", "again"});
  EXPECT_EQ(bytes_of(dir_ / "again/frame_0000.png"), bytes_of(dir_ / "r/frame_0000.png"));
}

TEST_F(Prints, mistakes_leave_nothing_behind) {
  const auto refuse = [&](const Words& flags, const std::string& message) {
    expect_refusal(run_tool(dir_, Words{"convert", "in", "bad/out.png"} + flags), 2, message);
    EXPECT_FALSE(fs::exists(dir_ / "bad")) << message;
  };
  refuse({"--lpi", "0", "--dpi", "80", "--paper", "A6"}, "--lpi");
  refuse({"--lpi", "20", "--paper", "A6"}, "without --dpi");
  refuse({"--lpi", "20", "--dpi", "80", "--paper", "B7"}, "A0 to A8, letter");
  refuse({"--lpi", "60", "--dpi", "80", "--paper", "A6"}, "lenses 1.333 pixels wide");
  refuse({"--lpi", "1", "--dpi", "80", "--paper", "10x10mm"}, "lenses 80.000 pixels wide");
  refuse(Words{"--keep", "1"} + sheet_, "2 or more pictures");
  refuse({"--display", "portrait", "--mirror"}, "--mirror: has no effect");
  refuse({"--display", "portrait", "--to", "integral"}, "native or quilt");
  refuse({"--dpi", "80", "--display", "portrait"}, "--dpi: cannot be combined with --display");
}

TEST_F(Prints, a_folder_with_one_picture_is_refused) {
  fs::create_directories(dir_ / "one");
  fs::copy_file(dir_ / "in/view_000.png", dir_ / "one/a.png");
  expect_refusal(run_tool(dir_, Words{"convert", "one", "out.png"} + sheet_), 1, "contains only one picture, a.png");
  EXPECT_FALSE(fs::exists(dir_ / "out.png"));
}

}  // namespace
}  // namespace lippmann::test

// RGB-D pictures out of a render, and views out of an RGB-D picture.
#include <gmock/gmock.h>

#include "cli/tool.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Image8 codes_of_file(const std::filesystem::path& path) { return std::get<Image8>(read_picture(path)); }

TEST(Rgbd, views_of_a_render_s_middle_and_its_depth_are_like_the_true_ones) {
  const TempDir dir;
  rendered(dir,
           {"render", "room", "--optics", "multiview", "--views", "5x1", "--size", "640x128", "--view-angle", "10", "--frames",
            "0", "--spp", "16", "--aov", "depth", "-o", "true"},
           "true");
  ASSERT_EQ(run_tool(dir, {"convert", "true", "middle", "--to", "rgbd"}).exit_code, 0);
  ASSERT_EQ(run_tool(dir, {"convert", "true", "views", "--to", "views"}).exit_code, 0);
  const json made = report_of(
      dir, {"convert", "middle/frame_0000_rgbd.png", "made", "--to", "views", "--views", "5x1", "--view-angle", "10"});
  EXPECT_EQ(made["views"], json({5, 1}));
  EXPECT_LT(made["filled_share"].get<double>(), 0.05);
  const auto psnr = [&](const std::string& view) {
    return measure_difference(codes_of_file(dir / "views/frame_0000" / view), codes_of_file(dir / "made" / view)).psnr_db;
  };
  EXPECT_GT(psnr("view_002.png"), 50.0) << "the picture itself";
  for (const char* view : {"view_000.png", "view_001.png", "view_003.png", "view_004.png"}) EXPECT_GT(psnr(view), 25.0) << view;
}

TEST(Rgbd, render_writes_one_view_with_depth_and_its_side_file) {
  const TempDir dir;
  const Words room{"render", "room", "--size", "64x48", "--frames", "0"};
  rendered(dir, room + Words{"--layout", "rgbd", "-o", "a"}, "a");
  rendered(dir, room + Words{"--to", "rgbd", "-o", "b"}, "b");
  EXPECT_EQ(bytes_of(dir / "a/frame_0000_rgbd.png"), bytes_of(dir / "b/frame_0000_rgbd.png"));
  EXPECT_EQ(bytes_of(dir / "a/frame_0000_rgbd.png.json"), bytes_of(dir / "b/frame_0000_rgbd.png.json"));
  EXPECT_EQ(codes_of_file(dir / "a/frame_0000_rgbd.png").width, 128);
}

TEST(Rgbd, render_says_what_its_pictures_are_called) {
  const TempDir dir;
  const RunResult made = run_tool(dir, {"render", "room", "--size", "64x48", "--frames", "0", "--layout", "rgbd", "-o", "a"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("pictures  a/frame_0000_rgbd.png"));
}

TEST(Rgbd, picture_is_shown_on_a_display) {
  const TempDir dir;
  rendered(dir, {"render", "room", "--size", "60x80", "--frames", "0", "--layout", "rgbd", "-o", "a"}, "a");
  const RunResult shown =
      run_tool(dir, {"convert", "a", "q", "--to", "quilt", "--display", "portrait", "--depth-scale", "0.5"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("of them filled"));
  const Image8 quilt = codes_of_file(dir / "q/frame_0000_qs8x6a0.75.png");
  EXPECT_EQ(quilt.width, 3360);
  const json pair = report_of(dir, {"convert", "a", "p", "--to", "stereo", "--ipd", "5"});
  EXPECT_EQ(pair["view_size"], json({60, 80}));
}

TEST(Rgbd, pictures_without_a_side_file_say_what_is_assumed) {
  const TempDir dir;
  write_picture(dir / "x.png", Image8{4, 2, std::vector<unsigned char>(24, 90)});
  const RunResult shown = run_tool(dir, {"convert", "x.png", "v", "--from", "rgbd", "--to", "views", "--views", "3x1"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.err, HasSubstr("--depth-range"));
  expect_refusal(run_tool(dir, {"convert", "x.png", "v2", "--from", "quilt", "--to", "views", "--near-black"}), 2,
                 "--from rgbd");
}

}  // namespace
}  // namespace lippmann::test

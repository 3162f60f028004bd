// `render --layout`: what each frame's picture holds, and what its files are called.
#include <gmock/gmock.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

/// Two frames through 8 lenses of 4 x 4 pixels: 16 views of 8 x 8.
Words small_array(const std::string& folder) {
  return {"render",        "teapot", "--optics", "microlens", "--lenses", "8",
          "--lens-pixels", "4",      "--frames", "3-4",       "--output", folder};
}

TEST(Layout, views_are_those_that_convert_cuts_from_the_integral_image) {
  const TempDir dir;
  rendered(dir, small_array("whole"), "whole");
  rendered(dir, small_array("cut") + Words{"--layout", "views"}, "cut");
  ASSERT_EQ(run_tool(dir, {"convert", "whole", "views", "--from", "integral", "--views", "4x4", "--to", "views"}).exit_code, 0);
  for (const char* frame : {"frame_0003", "frame_0004"}) {
    const Files cut = files_in(dir / "cut" / frame, ".png");
    EXPECT_EQ(cut.size(), 16u);
    EXPECT_EQ(cut, files_in(dir / "views" / frame, ".png"));
  }
}

TEST(Layout, quilt_is_that_of_convert_and_says_its_tiles_in_its_name) {
  const TempDir dir;
  rendered(dir, small_array("whole"), "whole");
  const Files quilts = rendered(dir, small_array("quilts") + Words{"--layout", "quilt", "--quilt", "8x2"}, "quilts");
  ASSERT_TRUE(quilts.contains("frame_0003_qs8x2a1.png"));
  ASSERT_EQ(run_tool(dir, {"convert", "whole/frame_0003.png", "one.png", "--from", "integral", "--views", "4x4", "--to",
                           "quilt", "--quilt", "8x2"})
                .exit_code,
            0);
  EXPECT_EQ(quilts.at("frame_0003_qs8x2a1.png"), bytes_of(dir / "one_qs8x2a1.png"));
}

TEST(Layout, quilt_s_video_says_its_tiles_in_its_name_too) {
  const TempDir dir;
  const auto report = report_of(dir, small_array("out") + Words{"--layout", "quilt", "--video", "a.mkv"});
  EXPECT_EQ(report["videos"], nlohmann::json::array({"a_qs4x4a1.mkv"}));
  EXPECT_TRUE(std::filesystem::exists(dir / "a_qs4x4a1.mkv"));
}

TEST(Layout, views_of_a_quilt_are_its_tiles) {
  const TempDir dir;
  const Words quilt{"render", "teapot", "--optics", "multiview", "--views", "2x2", "--size", "32x48", "--frames", "3"};
  rendered(dir, quilt + Words{"-o", "q", "--layout", "quilt"}, "q");
  rendered(dir, quilt + Words{"-o", "v", "--layout", "views"}, "v");
  ASSERT_EQ(run_tool(dir, {"convert", "q/frame_0003_qs2x2a0.666667.png", "c", "--from", "quilt", "--to", "views"}).exit_code,
            0);
  EXPECT_EQ(files_in(dir / "v/frame_0003", ".png"), files_in(dir / "c", ".png"));
}

TEST(Layout, pseudoscopic_pictures_are_the_others_with_every_elemental_image_turned_round) {
  const TempDir dir;
  rendered(dir, small_array("plain"), "plain");
  const Files recorded = rendered(dir, small_array("recorded") + Words{"--pseudoscopic"}, "recorded");
  ASSERT_EQ(run_tool(dir, {"convert", "plain", "turned", "--rotate-elemental"}).exit_code, 0);
  EXPECT_EQ(recorded, files_in(dir / "turned", ".png"));
}

TEST(Layout, frame_of_which_a_view_is_missing_is_rendered_again_on_resume) {
  const TempDir dir;
  const Words views = small_array("out") + Words{"--layout", "views"};
  rendered(dir, views, "out");
  const Files before = files_in(dir / "out/frame_0004", ".png");
  std::filesystem::remove(dir / "out/frame_0004/view_007.png");
  const RunResult resumed = run_tool(dir, views + Words{"--resume"});
  EXPECT_THAT(resumed.out, HasSubstr("1 kept from before"));
  EXPECT_EQ(files_in(dir / "out/frame_0004", ".png"), before);
}

TEST(Layout, extra_layers_lie_as_the_pictures_do) {
  const TempDir dir;
  rendered(dir, small_array("out") + Words{"--layout", "views", "--aov", "depth"}, "out");
  EXPECT_EQ(files_in(dir / "out/frame_0003", ".exr").size(), 16u);
  rendered(dir, small_array("exr") + Words{"--layout", "views", "--aov", "depth", "--format", "exr"}, "exr");
  EXPECT_EQ(files_in(dir / "exr/frame_0003", ".exr").size(), 16u);
}

TEST(Layout, what_cannot_be_is_refused_before_anything_is_made) {
  const TempDir dir;
  const auto refused = [&](const Words& words, const std::string& message) {
    expect_refusal(run_tool(dir, Words{"render", "teapot", "--frames", "0", "-o", "none"} + words), 2, message);
    EXPECT_FALSE(std::filesystem::exists(dir / "none"));
  };
  refused({"--layout", "views", "--lens-pixels", "7.5", "--lenses", "8"}, "whole number of pixels");
  refused({"--layout", "quilt", "--optics", "microlens", "--packing", "hexagonal"}, "whole number of pixels");
  refused({"--layout", "quilt", "--quilt", "3x2"}, "not as many as 8 views");
  refused({"--quilt", "4x2"}, "--layout quilt");
  refused({"--pseudoscopic", "--layout", "quilt"}, "--layout integral");
  refused({"--layout", "views", "--video", "a.mp4"}, "pictures of their own");
}

TEST(Layout, tiff_pictures_hold_the_codes_of_png) {
  const TempDir dir;
  rendered(dir, small_array("png"), "png");
  rendered(dir, small_array("tiff") + Words{"--format", "tiff"}, "tiff");
  const RunResult compared = run_tool(dir, {"compare", "png/frame_0003.png", "tiff/frame_0003.tif", "--json"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_TRUE(json_of(compared.out)["identical"]);
}

TEST(Layout, tiff_pictures_written_twice_are_the_same_bytes) {
  const TempDir dir;
  rendered(dir, small_array("a") + Words{"--format", "tiff"}, "a");
  const std::string first = bytes_of(dir / "a/frame_0003.tif");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // TIFF's time stamps count seconds
  rendered(dir, small_array("b") + Words{"--format", "tiff"}, "b");
  EXPECT_EQ(bytes_of(dir / "b/frame_0003.tif"), first);
}

TEST(Layout, pictures_too_large_for_their_file_are_refused_before_the_first_frame) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"render", "teapot", "--size", "20000x20000", "--frames", "0", "-o", "out"}), 2,
                 "--format tiff");
  expect_refusal(run_tool(dir, {"render", "teapot", "--size", "65536x32768", "--frames", "0", "-o", "out"}), 2,
                 "2147483647 pixels");
  EXPECT_FALSE(std::filesystem::exists(dir / "out/job.toml"));
}

TEST(Layout, tiff_on_a_full_disk_is_one_error_and_leaves_nothing) {
  const TempDir dir;
  const RunResult result =
      run_tool(dir, {"render", "tree", "--lenses", "32", "--frames", "0", "--format", "tiff", "-o", "out"}, 20000);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("frame_0000.tif: cannot be written as TIFF"));
  EXPECT_FALSE(std::filesystem::exists(dir / "out/frame_0000.tif"));
}

}  // namespace
}  // namespace lippmann::test

#include <gtest/gtest.h>

#include "tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

TEST(Encode, quilt_frames_give_a_named_video) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, {"render", "gears", "--optics", "multiview", "--views", "2x2", "--size", "64x64", "--frames", "0-2",
                           "--layout", "quilt", "-o", "r"})
                .exit_code,
            0);
  const nlohmann::json report = report_of(dir, {"encode", "r", "gears.webm", "--crf", "30"});
  EXPECT_EQ(report["file"], "gears_qs2x2a1.webm");
  EXPECT_EQ(report["frames"], 3);
  EXPECT_TRUE(std::filesystem::exists(dir / "gears_qs2x2a1.webm"));
  EXPECT_EQ(report_of(dir, {"encode", "r", "part.mkv", "--range", "1-2"})["frames"], 2);
  EXPECT_EQ(report_of(dir, {"encode", "r", "part.mkv", "--frames", "0,2"})["frames"], 2);
}

TEST(Encode, stereo_folder_equals_the_renders_video) {
  const TempDir dir;
  expect_done(dir, {"render", "teapot", "--layout", "stereo", "--frames", "3", "--viewing-distance", "600", "--size", "128x36",
                    "-o", "r", "--video", "a.mkv"});
  expect_done(dir, {"encode", "r", "b.mkv"});
  EXPECT_EQ(bytes_of(dir / "a_2x1.mkv"), bytes_of(dir / "b_2x1.mkv"));
}

TEST(Encode, rate_defaults_to_the_renders) {
  const TempDir dir;
  EXPECT_EQ(report_of(dir, small_teapot("0-2", "r") + Words{"--fps", "12"})["frames_per_second"], 12.0);
  for (const Words& rate : {Words{}, Words{"--fps", "12"}, Words{"--fps", "25"}})
    ASSERT_EQ(run_tool(dir, Words{"encode", "r", "v" + (rate.empty() ? "" : rate[1]) + ".mkv"} + rate).exit_code, 0);
  EXPECT_EQ(bytes_of(dir / "v.mkv"), bytes_of(dir / "v12.mkv"));
  EXPECT_NE(bytes_of(dir / "v.mkv"), bytes_of(dir / "v25.mkv"));
  fs::remove(dir / "r/report.json");
  ASSERT_EQ(run_tool(dir, {"encode", "r", "usual.mkv"}).exit_code, 0);
  EXPECT_EQ(bytes_of(dir / "usual.mkv"), bytes_of(dir / "v25.mkv"));
}

TEST(Encode, impossible_videos_are_one_message) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0", "r")).exit_code, 0);
  expect_refusal(run_tool(dir, {"encode", "r", "a.gif"}), 1, ".webm");
  expect_refusal(run_tool(dir, {"encode", "r", "a.mov", "--codec", "vp9"}), 1, "cannot contain vp9");
  expect_refusal(run_tool(dir, {"encode", "r", "a.mp4", "--codec", "x264"}), 2, "h264, hevc, vp9, av1, ffv1");
  expect_refusal(run_tool(dir, {"encode", "r", "a.mp4", "--crf", "99"}), 1, "0 to 51");
  expect_refusal(run_tool(dir, {"encode", "r", "a.mp4", "--range", "0-3"}), 1, "frame 1 is missing");
  expect_refusal(run_tool(dir, {"encode", "none", "a.mp4"}), 1, "none");
  EXPECT_FALSE(std::filesystem::exists(dir / "a.mp4"));
}

TEST(Render, unsupported_codec_is_refused_first) {
  const TempDir dir;
  expect_refusal(run_tool(dir, small_teapot("0", "r") + Words{"--video", "a.webm", "--video-codec", "h264"}), 1,
                 "cannot contain h264");
  EXPECT_FALSE(std::filesystem::exists(dir / "r/frame_0000.png"));
}

}  // namespace
}  // namespace lippmann::test

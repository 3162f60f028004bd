#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/tool.hpp"
#include "support/small_panel.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

TEST(Render, writes_pictures_job_and_report) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0-2", "out"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(files_in(dir / "out", ".png").size(), 3u);
  EXPECT_TRUE(std::filesystem::exists(dir / "out/frame_0002.png"));
  EXPECT_TRUE(std::filesystem::exists(dir / "out/job.toml"));
  EXPECT_TRUE(std::filesystem::exists(dir / "out/report.json"));
  EXPECT_THAT(result.out, HasSubstr("out/frame_0000.png"));
}

TEST(Render, default_output_is_out_slash_scene) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, {"render", "teapot", "--lenses", "4", "--frames", "7"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(dir / "out/teapot/frame_0007.png"));
}

TEST(Render, terminal_gets_a_progress_bar) {
  const TempDir dir;
  std::string command;
  for (const std::string& word : tool_command(small_teapot("0-3", "out"))) command += "'" + word + "' ";
  const RunResult result = run({"script", "--quiet", "--return", "--command", command, "/dev/null"}, {dir.path().string(), 0});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\r[################################] 4/4"));
  EXPECT_THAT(result.out, HasSubstr("0:00 left"));
  EXPECT_THAT(result.out, Not(HasSubstr("frame 3: ")));
}

TEST(Render, json_is_only_the_report) {
  const TempDir dir;
  const nlohmann::json printed = report_of(dir, small_teapot("3-4", "out"));
  EXPECT_EQ(printed, json_of(bytes_of(dir / "out/report.json")));
}

TEST(Render, flags_override_the_job) {
  const TempDir dir;
  std::ofstream(dir / "in.toml") << "scene = 'teapot'\nlenses = 4\nframes = '0-1'\n";
  ASSERT_EQ(run_tool(dir, {"render", "--job", "in.toml", "--frames", "1", "--output", "a", "--dump-job", "out.toml"}).exit_code,
            0);
  EXPECT_EQ(files_in(dir / "a", ".png").size(), 1u);
  EXPECT_THAT(bytes_of(dir / "out.toml"), HasSubstr("frames = \"1\""));
  EXPECT_THAT(bytes_of(dir / "out.toml"), HasSubstr("lenses = \"4\""));
}

TEST(Render, summary_reports_missed_pixels) {
  const TempDir dir;
  const RunResult result =
      run_tool(dir, small_teapot("0-4", "a") + Words{"--reuse", "forward", "--keyframes", "4", "--verbose"});
  EXPECT_THAT(result.out, HasSubstr("3 frames interpolated between 2 traced frames"));
  EXPECT_THAT(result.out, HasSubstr("not covered"));
  EXPECT_THAT(result.err, HasSubstr("between key frames"));
}

TEST(Render, also_single_renders_the_middle_view) {
  const TempDir dir;
  write_small_panel(dir / "panel.toml");
  const Words panel{"render", "teapot", "--frames", "3", "--display", "panel.toml"};
  expect_done(dir, panel + Words{"-o", "out", "--also", "single", "--video", "a.mkv"});
  EXPECT_TRUE(std::filesystem::exists(dir / "a_qs4x2a0.75.mkv"));
  EXPECT_TRUE(std::filesystem::exists(dir / "a_single.mkv"));
  expect_done(dir, panel + Words{"--optics", "single", "-o", "one"});
  EXPECT_EQ(files_in(dir / "out/single", ".png"), files_in(dir / "one", ".png"));
  EXPECT_EQ(files_in(dir / "one", ".png").size(), 1u);
}

}  // namespace
}  // namespace lippmann::test

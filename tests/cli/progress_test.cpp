#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

std::vector<std::string> split(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  return all;
}

std::size_t size_of(const std::filesystem::path& folder, const std::string& ending) {
  std::size_t sum = 0;
  for (const auto& [name, bytes] : files_in(folder, ending)) sum += bytes.size();
  return sum;
}

TEST(RenderProgress, without_terminal_prints_first_and_last_frame) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0-3", "out") + Words{"--full-depth"});
  const std::vector<std::string> lines = split(result.err);
  ASSERT_EQ(lines.size(), 3u) << result.err;
  EXPECT_THAT(lines[0], AllOf(HasSubstr("4 frames of 128x128 pixels to out"), HasSubstr("MB (an estimate)")));
  EXPECT_THAT(lines[1], AllOf(HasSubstr("[1/4] frame 0: "), HasSubstr(" left, files: about ")));
  EXPECT_THAT(lines[2], AllOf(HasSubstr("[4/4] frame 3: "), HasSubstr("; done, files: ")));
  EXPECT_THAT(result.err, Not(HasSubstr("\r")));
}

TEST(RenderProgress, verbose_prints_every_frame) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0-3", "out") + Words{"-v"});
  EXPECT_EQ(reported_frames(result.err), 4u) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("[2/4] frame 1: "), HasSubstr("[3/4] frame 2: ")));
}

TEST(RenderProgress, json_has_one_object_per_line) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("2-5", "out") + Words{"--progress", "json", "--aov", "depth"});
  const std::vector<std::string> lines = split(result.err);
  ASSERT_EQ(lines.size(), 5u) << result.err;
  const Json before = json_of(lines[0]), last = json_of(lines[4]);
  EXPECT_TRUE(before["frame"].is_null());
  EXPECT_TRUE(before["seconds_left"].is_null());
  EXPECT_EQ(before["frames"], 4);
  EXPECT_EQ(before["share"], 0.0);
  EXPECT_GT(before["estimated_bytes"], 0);
  for (int i = 1; i <= 4; ++i) {
    const Json frame = json_of(lines[static_cast<std::size_t>(i)]);
    EXPECT_EQ(frame["frame"], i + 1);
    EXPECT_EQ(frame["done"], i);
    EXPECT_GE(frame["seconds_left"], 0.0);
    EXPECT_EQ(frame["share"], i / 4.0);
  }
  const std::size_t files = size_of(dir / "out", ".png") + size_of(dir / "out", ".exr");
  EXPECT_EQ(last["bytes"], files) << "pictures and layers";
  EXPECT_EQ(last["estimated_bytes"], files);
  EXPECT_EQ(last["seconds_left"], 0.0);
}

TEST(RenderProgress, size_counts_the_panels_pixels) {
  const TempDir dir;
  std::ofstream(dir / "small.toml") << "base = 'looking-glass-portrait'\npixels = [96, 128]\n";
  const RunResult result =
      run_tool(dir, {"render", "teapot", "--display", "small.toml", "--layout", "native", "--frames", "0"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("1 frame of 96x128 pixels"));
  EXPECT_THAT(result.out, HasSubstr("1 frame of 96x128 pixels"));
  EXPECT_THAT(run_tool(dir, {"info", "teapot", "--display", "small.toml", "--layout", "native"}).out,
              HasSubstr("96x128 pixels of"));
}

TEST(DryRun, estimate_is_near_the_actual_size) {
  const TempDir dir;
  const Words all = small_teapot("0-7", "r") + Words{"--aov", "depth,normal", "--video", "r/a.mkv"};
  const Json plan = report_of(dir, all + Words{"--dry-run"});
  ASSERT_EQ(run_tool(dir, all).exit_code, 0);
  for (const auto& [part, ending] : {std::pair("pictures", ".png"), std::pair("layers", ".exr"), std::pair("videos", ".mkv")}) {
    const double ratio = static_cast<double>(size_of(dir / "r", ending)) / plan["estimated"][part].get<double>();
    // estimates assume typical detail; files of plain or detailed scenes differ by a factor of two
    EXPECT_GT(ratio, 0.3) << part;
    EXPECT_LT(ratio, 3.0) << part;
  }
  EXPECT_THAT(run_tool(dir, all + Words{"--dry-run"}).out,
              AllOf(HasSubstr("(an estimate)"), HasSubstr("layers"), HasSubstr("videos")));
}

TEST(DryRun, estimates_of_light_fields_count_their_depth_files) {
  for (const char* format : {"hci", "nerf", "cvkit", "miv", "colmap", "jpeg-pleno"}) {
    const TempDir dir;
    const Words all{"render", "room", "--optics", "multiview", "--camera-grid", "--views", "3x3",  "--size", "384x384",
                    "--spp",  "1",    "--frames", "0",         "--denoise",     "none",    "--to", format,   "-o",
                    "r"};
    const Json plan = report_of(dir, all + Words{"--dry-run"});
    ASSERT_EQ(run_tool(dir, all).exit_code, 0);
    double bytes = 0.0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(dir / "r/frame_0000"))
      if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
    const double ratio = bytes / plan["estimated_bytes"].get<double>();
    // Estimates are means over three scenes. The measured file sizes of these scenes differ from the estimates by a
    // factor of at most 1.3.
    EXPECT_GT(ratio, 1.0 / 1.5) << format;
    EXPECT_LT(ratio, 1.5) << format;
  }
}

TEST(FittedDepth, is_the_default_and_reported) {
  const TempDir dir;
  const RunResult fitted = run_tool(dir, small_teapot("0", "a")),
                  full = run_tool(dir, small_teapot("0", "b") + Words{"--full-depth"});
  EXPECT_THAT(fitted.err, AllOf(HasSubstr("Its depth is scaled to"), HasSubstr("--full-depth shows its full depth.")));
  EXPECT_THAT(fitted.out, HasSubstr("--full-depth shows its full depth."));
  EXPECT_THAT(full.err, Not(HasSubstr("depth")));
  EXPECT_THAT(full.out, HasSubstr("--fit-depth scales its depth to the budget."));
  const Json a = json_of(bytes_of(dir / "a/report.json")), b = json_of(bytes_of(dir / "b/report.json"));
  EXPECT_LT(a["depth"]["scale"], 0.9);
  EXPECT_EQ(a["depth"]["fits"], true);
  EXPECT_TRUE(a["settings"]["fit-depth"].is_null());
  EXPECT_EQ(b["depth"]["scale"], 1.0);
  EXPECT_EQ(b["settings"]["fit-depth"], false);
}

TEST(FittedDepth, is_reported_by_a_dry_run) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, small_teapot("0", "a") + Words{"-n"}).out, HasSubstr("Its depth is scaled to"));
  EXPECT_LT(report_of(dir, small_teapot("0", "a") + Words{"-n"})["depth"]["scale"], 0.9);
}

}  // namespace
}  // namespace lippmann::test

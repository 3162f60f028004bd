// What the tool loads: little to start with, FFmpeg only for videos, from where it was built or is installed.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Words kEncode{"encode", "r", "a.mp4"};

/// The tool alone in `dir`/bin, and frames in `dir`/r.
Words lone_tool(const TempDir& dir) {
  fs::create_directory(dir / "bin");
  fs::copy_file(LIPPMANN_TOOL, dir / "bin/lippmann");
  EXPECT_EQ(run_tool(dir, small_teapot("0", "r")).exit_code, 0);
  return {(dir / "bin/lippmann").string()};
}

RunResult run_lone(const TempDir& dir, const Words& command) { return run(command, {.working_folder = dir.path().string()}); }

/// The shared libraries that the dynamic linker starts in a run of the tool, those that are loaded later too.
std::set<std::string> libraries_of(const Words& arguments) {
  const TempDir dir;
  const RunResult traced =
      run(Words{"env", "LD_DEBUG=files"} + tool_command(arguments), {.working_folder = dir.path().string()});
  EXPECT_EQ(traced.exit_code, 0);
  const std::regex started("calling init: (\\S+)");
  std::set<std::string> libraries;
  for (std::sregex_iterator line(traced.err.begin(), traced.err.end(), started), end; line != end; ++line)
    libraries.insert((*line)[1]);
  return libraries;
}

// Each costs time and memory at every start. OpenImageIO and FFmpeg brought more than two hundred.
TEST(Start, version_starts_at_most_60_shared_libraries_and_none_of_ffmpeg) {
  const std::set<std::string> libraries = libraries_of({"--version"});
  EXPECT_THAT(libraries, testing::Contains(HasSubstr("libembree"))) << "else the linker's trace is not what this test reads";
  EXPECT_LE(libraries.size(), 60u) << testing::PrintToString(libraries);
  EXPECT_THAT(libraries, Not(testing::Contains(HasSubstr("libav"))));
}

TEST(Start, picture_is_rendered_with_at_most_60_shared_libraries) {
  EXPECT_LE(libraries_of(small_teapot("0", "r")).size(), 60u);
}

TEST(Start, without_the_video_module_only_videos_fail_and_the_message_says_where_it_is_looked_for) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  EXPECT_EQ(run_lone(dir, tool + Words{"--version"}).exit_code, 0);
  const RunResult refused = run_lone(dir, tool + kEncode);
  expect_refusal(refused, 1, "liblippmann_video.so: videos need this module, and it is not installed");
  EXPECT_THAT(refused.err, AllOf(HasSubstr((dir / "bin/liblippmann_video.so").string()),
                                 HasSubstr((dir / "lib/lippmann/liblippmann_video.so").string())));
}

TEST(Start, without_the_align_module_alignment_names_its_package) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  fs::create_directory(dir / "in");
  for (const char* name : {"in/1.png", "in/2.png"}) fs::copy_file(dir / "r/frame_0000.png", dir / name);
  const RunResult refused = run_lone(dir, tool + Words{"align", "in", "out"});
  expect_refusal(refused, 1,
                 "liblippmann_align.so: alignment and depth from two pictures need this module, and it is not installed");
  EXPECT_THAT(refused.err, HasSubstr("(package lippmann-align)"));
  EXPECT_FALSE(fs::exists(dir / "out"));
}

TEST(Start, video_module_is_found_where_it_is_installed) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  fs::create_directories(dir / "lib/lippmann");
  fs::copy_file(LIPPMANN_VIDEO_MODULE, dir / "lib/lippmann/liblippmann_video.so");
  const RunResult encoded = run_lone(dir, tool + kEncode);
  EXPECT_EQ(encoded.exit_code, 0) << encoded.err;
  EXPECT_TRUE(fs::exists(dir / "a.mp4"));
}

TEST(Start, video_module_that_cannot_be_loaded_is_named_with_the_reason) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  std::ofstream(dir / "bin/liblippmann_video.so") << "no library";
  const RunResult refused = run_lone(dir, tool + kEncode);
  expect_refusal(refused, 1, "liblippmann_video.so: videos need this module, and it cannot be loaded");
}

}  // namespace
}  // namespace lippmann::test

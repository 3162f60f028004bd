// What the tool loads: little to start with, FFmpeg only for videos, from where it was built or is installed.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

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

TEST(Start, without_the_video_module_only_videos_fail_and_the_message_says_where_it_is_looked_for) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  EXPECT_EQ(run_lone(dir, tool + Words{"--version"}).exit_code, 0);
  const RunResult refused = run_lone(dir, tool + kEncode);
  expect_refusal(refused, 1, "liblippmann_video.so: videos need this module, and it is not installed");
  EXPECT_THAT(refused.err, AllOf(HasSubstr((dir / "bin/liblippmann_video.so").string()),
                                 HasSubstr((dir / "lib/lippmann/liblippmann_video.so").string())));
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

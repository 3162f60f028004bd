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

/// Copies the tool without its modules to `dir`/bin, and renders frames to `dir`/r.
Words lone_tool(const TempDir& dir) {
  fs::create_directory(dir / "bin");
  fs::copy_file(LIPPMANN_TOOL, dir / "bin/lippmann");
  EXPECT_EQ(run_tool(dir, small_teapot("0", "r")).exit_code, 0);
  return {(dir / "bin/lippmann").string()};
}

RunResult run_lone(const TempDir& dir, const Words& command) { return run(command, {.working_folder = dir.path().string()}); }

/// Returns the shared libraries that a run loads, including those loaded with dlopen.
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

// OpenImageIO and FFmpeg alone would load more than 200 libraries at every start.
TEST(Start, version_loads_few_libraries) {
  const std::set<std::string> libraries = libraries_of({"--version"});
  EXPECT_THAT(libraries, testing::Contains(HasSubstr("libembree"))) << "otherwise the test cannot parse the linker's trace";
  EXPECT_LE(libraries.size(), 60u) << testing::PrintToString(libraries);
  EXPECT_THAT(libraries, Not(testing::Contains(HasSubstr("libav"))));
}

TEST(Start, render_loads_few_libraries) { EXPECT_LE(libraries_of(small_teapot("0", "r")).size(), 60u); }

TEST(Start, missing_video_module_fails_only_videos) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  EXPECT_EQ(run_lone(dir, tool + Words{"--version"}).exit_code, 0);
  const RunResult refused = run_lone(dir, tool + kEncode);
  expect_refusal(refused, 1, "liblippmann_video.so: videos need this module, and it is not installed");
  EXPECT_THAT(refused.err, AllOf(HasSubstr((dir / "bin/liblippmann_video.so").string()),
                                 HasSubstr((dir / "lib/lippmann/liblippmann_video.so").string())));
}

TEST(Start, missing_align_module_names_its_package) {
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

TEST(Start, missing_hdf5_module_names_its_package) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  fs::copy_file(LIPPMANN_SOURCE "/tests/formats/files/lf.h5", dir / "lf.h5");
  const RunResult refused = run_lone(dir, tool + Words{"convert", "lf.h5", "out", "--to", "hci"});
  expect_refusal(refused, 1, "liblippmann_hdf5.so: HDF5 files need this module, and it is not installed");
  EXPECT_THAT(refused.err, HasSubstr("(package lippmann-hdf5)"));
  EXPECT_FALSE(fs::exists(dir / "out"));
}

TEST(Start, installed_video_module_is_found) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  fs::create_directories(dir / "lib/lippmann");
  fs::copy_file(LIPPMANN_VIDEO_MODULE, dir / "lib/lippmann/liblippmann_video.so");
  const RunResult encoded = run_lone(dir, tool + kEncode);
  EXPECT_EQ(encoded.exit_code, 0) << encoded.err;
  EXPECT_TRUE(fs::exists(dir / "a.mp4"));
}

TEST(Start, broken_video_module_gives_the_reason) {
  const TempDir dir;
  const Words tool = lone_tool(dir);
  std::ofstream(dir / "bin/liblippmann_video.so") << "no library";
  const RunResult refused = run_lone(dir, tool + kEncode);
  expect_refusal(refused, 1, "liblippmann_video.so: videos need this module, and it cannot be loaded");
}

}  // namespace
}  // namespace lippmann::test

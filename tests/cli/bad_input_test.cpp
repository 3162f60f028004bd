#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

void write(const std::filesystem::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// Refused with exit code 1 and one line, and nothing is made.
void expect_nothing_made(const TempDir& dir, const Words& arguments, const std::string& part_of_message) {
  expect_refusal(run_tool(dir, arguments), 1, part_of_message);
  EXPECT_FALSE(std::filesystem::exists(dir / "out"));
}

TEST(BadInput, scenes_that_are_missing_or_damaged_are_named) {
  const TempDir dir;
  expect_nothing_made(dir, {"render", "teepot"}, "did you mean 'teapot'?");
  for (const char* missing : {"none.dat", "none.glb", "none.toml"}) expect_nothing_made(dir, {"render", missing}, missing);
  write(dir / "a.dat", "BEGIN_SCENE\nRESOLUTION 8 8\nFROBNICATE 3\nEND_SCENE\n");
  expect_nothing_made(dir, {"render", "a.dat"}, "a.dat:3");
  write(dir / "a.glb", std::string("glTF\x02\0\0\0\xff\xff\0\0", 12));
  expect_nothing_made(dir, {"render", "a.glb"}, "a.glb");
  write(dir / "job.toml", "scene = 'teapot'\nlense = 3\n");
  expect_refusal(run_tool(dir, {"render", "job.toml"}), 2, "job.toml:2: there is no key 'lense', did you mean 'lenses'?");
}

TEST(BadInput, output_folder_that_cannot_be_made_is_named) {
  const TempDir dir;
  write(dir / "file", "");
  expect_refusal(run_tool(dir, small_teapot("0", "file/out")), 1, "file/out");
}

TEST(BadInput, video_of_unknown_kind_is_refused_before_rendering) {
  const TempDir dir;
  expect_nothing_made(dir, small_teapot("0", "out") + Words{"--video", "a.gif"}, "a.gif");
}

TEST(BadInput, full_disk_is_one_message_and_leaves_no_cut_picture) {
  const TempDir dir;
  for (const std::string format : {"png", "tiff"}) {
    const RunResult result = run_tool(dir, small_teapot("0-5", format) + Words{"--format", format}, 4096);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, testing::ContainsRegex("lippmann: " + format + "/frame_000[0-9]\\.(png|tif): "));
    EXPECT_EQ(result.err.find("lippmann: "), result.err.rfind("lippmann: ")) << "said once";
    EXPECT_EQ(files_in(dir / format, ".png").size() + files_in(dir / format, ".tif").size(), 0u);
  }
}

}  // namespace
}  // namespace lippmann::test

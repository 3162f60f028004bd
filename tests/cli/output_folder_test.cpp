#include <gmock/gmock.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

void render_teapot(const TempDir& dir) {
  const RunResult made = run_tool(dir, small_teapot("0-1", "pictures"));
  ASSERT_EQ(made.exit_code, 0) << made.err;
}

void expect_made(const TempDir& dir, const Words& arguments, const std::string& file) {
  const RunResult result = run_tool(dir, arguments);
  EXPECT_EQ(result.exit_code, 0) << arguments.front() << ": " << result.err;
  EXPECT_TRUE(fs::is_regular_file(dir / file)) << arguments.front() << " " << file;
}

TEST(OutputFolder, commands_make_the_folders_of_their_results) {
  const TempDir dir;
  render_teapot(dir);
  expect_made(dir, {"encode", "pictures", "encoded/of/pictures.mkv"}, "encoded/of/pictures.mkv");
  expect_made(dir, {"convert", "pictures/frame_0000.png", "converted/to/quilt", "--to", "quilt", "--quilt", "4x2"},
              "converted/to/quilt_qs4x2a1.png");
  expect_made(dir, {"convert", "pictures/frame_0000.png", "converted/as/views", "--to", "views"},
              "converted/as/views/view_000.png");
  expect_made(dir, {"compare", "pictures", "pictures", "--csv", "compared/as/table.csv"}, "compared/as/table.csv");
  expect_made(dir, {"replay", "pictures", "-o", "replayed/as/pictures", "--video", "replayed/as/video/eye.mkv"},
              "replayed/as/video/eye.mkv");
  expect_made(dir, small_teapot("0", "again") + Words{"--dump-job", "jobs/of/teapot.toml"}, "jobs/of/teapot.toml");
}

TEST(OutputFolder, failed_commands_leave_no_folder) {
  const TempDir dir;
  render_teapot(dir);
  const std::vector<Words> failing{
      {"encode", "pictures", "new/of/pictures.mp4", "--crf", "99"},
      {"convert", "pictures/frame_0000.png", "new/of/quilt.png", "--to", "quilt", "--quilt", "3x7"},
      {"compare", "pictures", "missing", "--csv", "new/of/table.csv"},
      {"replay", "pictures", "-o", "new/of/pictures", "--video", "new/of/eye.txt"}};
  for (const Words& arguments : failing) {
    EXPECT_NE(run_tool(dir, arguments).exit_code, 0) << arguments.front();
    EXPECT_FALSE(fs::exists(dir / "new")) << arguments.front();
  }
}

}  // namespace
}  // namespace lippmann::test

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "cli/tool.hpp"
#include "support/exr_file.hpp"

namespace lippmann::test {
namespace {

void write(const std::filesystem::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

void expect_nothing_made(const TempDir& dir, const Words& arguments, const std::string& part_of_message) {
  expect_refusal(run_tool(dir, arguments), 1, part_of_message);
  EXPECT_FALSE(std::filesystem::exists(dir / "out"));
}

TEST(BadInput, missing_and_damaged_scenes_are_named) {
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

// Opening a FIFO blocks until another process writes to it.
TEST(BadInput, fifos_are_refused_by_every_reader) {
  const TempDir dir;
  for (const char* name : {"a.glb", "a.gltf", "a.ply", "a.obj", "a.nff", "a.dat", "job.toml", "p.png", "p.hdr", "d.toml",
                           "d.json", "v.mp4", "report.json", "q_qs2x2a1.png.json"})
    ASSERT_EQ(mkfifo((dir / name).c_str(), 0600), 0);
  for (const char* scene : {"a.glb", "a.gltf", "a.ply", "a.obj", "a.nff", "a.dat", "job.toml"})
    expect_nothing_made(dir, {"render", scene, "-o", "out"}, "is not a regular file but a FIFO");
  const std::vector<Words> others{{"info", "a.ply"},
                                  {"render", "teapot", "-o", "out", "--environment", "p.hdr"},
                                  {"render", "teapot", "-o", "out", "--display", "d.toml"},
                                  {"render", "teapot", "-o", "out", "--display", "d.json"},
                                  {"compare", "p.png", "p.png"},
                                  {"compare", "v.mp4", "v.mp4"},
                                  {"convert", "p.png", "out", "--from", "integral", "--views", "2x1", "--to", "views"},
                                  {"convert", "p.png", "out", "--to", "views"},
                                  {"replay", "p.png"},
                                  {"report", "report.json"}};
  for (const Words& words : others) expect_nothing_made(dir, words, "is not a regular file but a FIFO");
}

// Escape sequences in names from files must not reach the terminal.
TEST(BadInput, control_characters_of_files_are_escaped) {
  const TempDir dir;
  ExrPart part;
  part.channels = {{"\x1b]0;owned\x07u", {1.0f}}, {"\x1b]0;owned\x07v", {1.0f}}};
  const std::vector<std::byte> file = exr_file(part);
  write(dir / "a.exr", {reinterpret_cast<const char*>(file.data()), file.size()});
  for (const Words& words : {Words{"compare", "a.exr", "a.exr"}, Words{"render", "teapot", "--environment", "a.exr"}}) {
    const RunResult result = run_tool(dir, words);
    expect_refusal(result, 1, "?]0;owned?u");
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
  }
}

TEST(BadInput, impossible_output_folder_is_named) {
  const TempDir dir;
  write(dir / "file", "");
  expect_refusal(run_tool(dir, small_teapot("0", "file/out")), 1, "file/out");
}

TEST(BadInput, unknown_video_kind_is_refused_first) {
  const TempDir dir;
  expect_nothing_made(dir, small_teapot("0", "out") + Words{"--video", "a.gif"}, "a.gif");
}

TEST(BadInput, full_disk_gives_one_message) {
  const TempDir dir;
  for (const std::string format : {"png", "tiff"}) {
    const RunResult result = run_tool(dir, small_teapot("0-5", format) + Words{"--format", format}, 4096);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, testing::ContainsRegex("lippmann: " + format + "/frame_000[0-9]\\.(png|tif): "));
    EXPECT_EQ(result.err.find("lippmann: "), result.err.rfind("lippmann: ")) << "one message";
    EXPECT_EQ(files_in(dir / format, ".png").size() + files_in(dir / format, ".tif").size(), 0u);
  }
}

}  // namespace
}  // namespace lippmann::test

// One folder holds one render: what another one is told, what becomes of its files, and what a check finds.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const Words kOther{"--view-angle", "40"};

TEST(Folder, render_with_other_settings_is_refused_in_one_line_and_changes_nothing) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-1", "a") + Words{"--aov", "depth"});
  const Files before = all_files(dir / "a");
  for (const Words& more : {Words{}, Words{"--resume"}, Words{"--dry-run"}}) {
    const RunResult other = run_tool(dir, small_teapot("0-1", "a") + kOther + more);
    expect_refusal(other, 1,
                   "a: holds another render: it differs in view-angle, aov; accepted: another folder (--output DIR); --force");
  }
  EXPECT_EQ(all_files(dir / "a"), before);
}

TEST(Folder, default_folder_keeps_its_render_and_the_next_one_gets_a_number) {
  const TempDir dir;
  const Words quick{"render", "teapot", "--lenses", "8", "--frames", "0", "--quiet"};
  expect_done(dir, quick);
  const Files first = all_files(dir / "out/teapot");
  for (int time = 0; time < 2; ++time) {
    const RunResult other = run_tool(dir, quick + kOther);
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_EQ(other.err,
              "warning: out/teapot holds another render, so this one is in out/teapot-2 (--force replaces the other, -o "
              "chooses)\n");
  }
  EXPECT_FALSE(fs::exists(dir / "out/teapot-3"));
  EXPECT_EQ(all_files(dir / "out/teapot"), first);
  EXPECT_EQ(run_tool(dir, quick).err, "");
  EXPECT_EQ(run_tool(dir, {"render", "out/teapot-2/job.toml", "--resume", "--quiet"}).err, "");
  EXPECT_THAT(run_tool(dir, quick + kOther + Words{"--dry-run"}).out, Not(HasSubstr("out/teapot\n")));
  expect_done(dir, quick + kOther + Words{"--force"});
  EXPECT_NE(all_files(dir / "out/teapot"), first);
}

TEST(Folder, second_render_of_the_default_folder_has_its_single_view_beside_it) {
  const TempDir dir;
  const Words quick{"render", "teapot", "--lenses", "8", "--frames", "0", "--also", "single"};
  expect_done(dir, quick);
  expect_done(dir, quick + kOther);
  EXPECT_TRUE(fs::exists(dir / "out/teapot-2/single/frame_0000.png"));
}

TEST(Folder, convert_writes_neither_into_the_folder_of_a_render_nor_over_its_pictures) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "a"));
  expect_done(dir, small_teapot("0", "b") + Words{"--view-angle", "40"});
  const Words to_integral{"--to", "integral"};
  expect_refusal(run_tool(dir, Words{"convert", "a", "b"} + to_integral), 1, "b: holds a render");
  expect_refusal(run_tool(dir, Words{"convert", "a/frame_0000.png", "b/frame_0000.png"} + to_integral), 1,
                 "b/frame_0000.png: is a file of the render");
  expect_refusal(run_tool(dir, {"convert", "a", "b", "--rotate-elemental"}), 1, "b: holds a render");
  expect_done(dir, {"check", "b"});
  expect_done(dir, Words{"convert", "a/frame_0000.png", "b/other.png"} + to_integral);
  expect_done(dir, Words{"convert", "a", "b/converted"} + to_integral);
}

// What a program opens that lies in a folder may be a FIFO, at which it would wait forever.
TEST(Folder, fifo_in_place_of_a_file_is_an_error_and_is_not_waited_for) {
  const TempDir dir;
  const Words quilt{"render",   "teapot", "--optics", "multiview", "--camera-grid", "--views", "2x2", "--size", "32x32",
                    "--layout", "quilt",  "--aov",    "depth",     "--frames",      "0-1",     "-o",  "a"};
  expect_done(dir, quilt);
  for (const auto& entry : std::vector<fs::directory_entry>(fs::directory_iterator(dir / "a"), {})) {
    const fs::path file = entry.path(), name = file.filename();
    if (entry.is_directory()) continue;  // the journal's, which journal_test knows
    fs::rename(file, dir / "kept");
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(run_tool(dir, {"check", "a"}).exit_code, 1) << name;
    for (const Words& reader : {Words{"convert", "a", "views", "--to", "views"}, Words{"replay", "a", "-o", "eye"}}) {
      const RunResult result = run_tool(dir, reader);
      const bool is_side_file = name.extension() == ".json" && name != "report.json";  // the report says more
      const bool is_read =
          (name.string().starts_with("frame_") && !(is_side_file && reader[0] == "replay")) || name == "report.json";
      EXPECT_EQ(result.exit_code, is_read) << reader[0] << name;
      EXPECT_THAT(result.err, HasSubstr(is_read ? name.string() : "")) << reader[0];
    }
    const RunResult deep = run_tool(dir, {"convert", "a", "hci", "--to", "hci"});
    EXPECT_THAT(deep.err, HasSubstr(name.string().starts_with("aov_") ? name.string() : "")) << name;
    const RunResult resumed = run_tool(dir, quilt + Words{"--resume"});
    EXPECT_EQ(resumed.exit_code, 1) << name;
    EXPECT_THAT(resumed.err, testing::AllOf(HasSubstr(name.string()), HasSubstr("regular file"))) << name;
    fs::remove(file);
    fs::rename(dir / "kept", file);
    fs::remove_all(dir / "views"), fs::remove_all(dir / "eye"), fs::remove_all(dir / "hci");
  }
}

TEST(Folder, check_prints_lists_as_json) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-1", "a") + Words{"--video", "film.mkv"});
  const nlohmann::json whole = json_of(run_tool(dir, {"check", "a", "--json"}).out);
  EXPECT_EQ(whole, (nlohmann::json{{"folder", "a"},
                                   {"frames", 2},
                                   {"files", 5},
                                   {"damaged", nlohmann::json::array()},
                                   {"missing", nlohmann::json::array()},
                                   {"foreign", nlohmann::json::array()},
                                   {"unfinished", nlohmann::json::array()},
                                   {"strips_left", nlohmann::json::object()},
                                   {"passed", true}}));
  fs::resize_file(dir / "film.mkv", fs::file_size(dir / "film.mkv") - 1);
  fs::remove(dir / "a/frame_0001.png");
  std::ofstream(dir / "a/aov_0001.exr") << "stale";
  const RunResult check = run_tool(dir, {"check", "a", "--json"});
  EXPECT_EQ(check.exit_code, 1);
  const nlohmann::json found = json_of(check.out);
  EXPECT_EQ(found["damaged"], nlohmann::json::array({"../film.mkv"}));
  EXPECT_EQ(found["missing"], nlohmann::json::array({"frame_0001.png"}));
  EXPECT_EQ(found["foreign"], nlohmann::json::array({"aov_0001.exr"}));
  EXPECT_EQ(found["passed"], false);
}

TEST(Folder, check_of_what_is_no_render_is_refused) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"check", "missing"}), 1, "missing: holds no render that can be checked");
  fs::create_directory(dir / ".lippmann");
  std::ofstream(dir / ".lippmann/1.jsonl") << "{\"job\":\"a\"}\n{\"frame\":0}\n{\"asked\":\"0\"}\n";
  expect_refusal(run_tool(dir, {"check", "."}), 1, "line 2 of '1.jsonl' lacks");
  expect_refusal(run_tool(dir, {"render", "teapot", "--frames", "0", "-o", "."}), 1, "line 2 of '1.jsonl' lacks");
}

}  // namespace
}  // namespace lippmann::test

// Tests that an output folder holds only one render, which files remain in it, and what `lippmann check` reports.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const Words kOther{"--view-angle", "40"};

TEST(Folder, other_settings_are_refused) {
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

TEST(Folder, default_folder_is_numbered_if_occupied) {
  const TempDir dir;
  const Words quick{"render", "teapot", "--lenses", "8", "--frames", "0", "--quiet"};
  expect_done(dir, quick);
  const Files first = all_files(dir / "out/teapot");
  for (int time = 0; time < 2; ++time) {
    const RunResult other = run_tool(dir, quick + kOther);
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_EQ(other.err,
              "warning: out/teapot holds another render, so this render is in out/teapot-2 (--force replaces the other "
              "render, -o DIR sets the folder)\n");
  }
  EXPECT_FALSE(fs::exists(dir / "out/teapot-3"));
  EXPECT_EQ(all_files(dir / "out/teapot"), first);
  EXPECT_EQ(run_tool(dir, quick).err, "");
  EXPECT_EQ(run_tool(dir, {"render", "out/teapot-2/job.toml", "--resume", "--quiet"}).err, "");
  EXPECT_THAT(run_tool(dir, quick + kOther + Words{"--dry-run"}).out, Not(HasSubstr("out/teapot\n")));
  expect_done(dir, quick + kOther + Words{"--force"});
  EXPECT_NE(all_files(dir / "out/teapot"), first);
}

TEST(Folder, single_view_is_beside_the_second_render) {
  const TempDir dir;
  const Words quick{"render", "teapot", "--lenses", "8", "--frames", "0", "--also", "single"};
  expect_done(dir, quick);
  expect_done(dir, quick + kOther);
  EXPECT_TRUE(fs::exists(dir / "out/teapot-2/single/frame_0000.png"));
}

TEST(Folder, convert_does_not_overwrite_a_render) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "a"));
  expect_done(dir, small_teapot("0", "b") + Words{"--view-angle", "40"});
  const Words to_integral{"--to", "integral"};
  expect_refusal(run_tool(dir, Words{"convert", "a", "b"} + to_integral), 1, "b: holds a render");
  expect_refusal(run_tool(dir, Words{"convert", "a/frame_0000.png", "b/frame_0000.png"} + to_integral), 1,
                 "b/frame_0000.png: would overwrite a file of the render");
  expect_refusal(run_tool(dir, {"convert", "a", "b", "--rotate-elemental"}), 1, "b: holds a render");
  expect_done(dir, {"check", "b"});
  expect_done(dir, Words{"convert", "a/frame_0000.png", "b/other.png"} + to_integral);
  expect_done(dir, Words{"convert", "a", "b/converted"} + to_integral);
}

// Opening a FIFO blocks until another process writes to it.
TEST(Folder, fifo_instead_of_a_file_is_refused) {
  const TempDir dir;
  const Words quilt{"render",   "teapot", "--optics", "multiview", "--camera-grid", "--views", "2x2", "--size", "32x32",
                    "--layout", "quilt",  "--aov",    "depth",     "--frames",      "0-1",     "-o",  "a"};
  expect_done(dir, quilt);
  for (const auto& entry : std::vector<fs::directory_entry>(fs::directory_iterator(dir / "a"), {})) {
    const fs::path file = entry.path(), name = file.filename();
    if (entry.is_directory()) continue;
    fs::rename(file, dir / "kept");
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(run_tool(dir, {"check", "a"}).exit_code, 1) << name;
    for (const Words& reader : {Words{"convert", "a", "views", "--to", "views"}, Words{"replay", "a", "-o", "eye"}}) {
      const RunResult result = run_tool(dir, reader);
      const bool is_side_file = name.extension() == ".json" && name != "report.json";
      // `convert` reads depth that it cannot write, to name it.
      const bool is_read = (name.string().starts_with("frame_") && !(is_side_file && reader[0] == "replay")) ||
                           (name.string().starts_with("aov_") && reader[0] == "convert") || name == "report.json";
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

std::set<std::string> names_below(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (const std::string name = entry.path().lexically_relative(folder);
        entry.is_regular_file() && name.find(".lippmann") == std::string::npos)
      names.insert(name);
  return names;
}

const Words kWithCompanions{"--also", "single", "--page", "--video", "a/film.mkv"};

TEST(Folder, unfinished_other_job_is_refused) {
  const TempDir dir;
  Subprocess slow(tool_command({"render", "teapot", "--size", "3000x3000", "--spp", "64", "--frames", "0", "-o", "a"}),
                  {dir.path().string(), 0});
  ASSERT_TRUE(appears(dir / "a/report.json"));
  for (const Words& flags : {Words{}, Words{"--force"}, Words{"--force", "--dry-run"}})
    expect_refusal(run_tool(dir, small_teapot("0", "a") + flags), 1, "another render has begun in it");
  EXPECT_FALSE(fs::exists(dir / "a/frame_0000.png"));
  slow.signal(SIGKILL);
  slow.wait();
  expect_done(dir, small_teapot("0", "a"));
  expect_done(dir, {"check", "a"});
}

TEST(Folder, removing_the_folder_is_an_error) {
  const TempDir dir;
  Subprocess running(tool_command(small_teapot("0-479", "a") + Words{"--layout", "views", "--quiet"}),
                     {dir.path().string(), 0});
  ASSERT_TRUE(appears(dir / "a/frame_0001"));
  std::error_code ignored;
  fs::rename(dir / "a", dir / "moved", ignored);
  const RunResult result = running.wait();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err, "");
}

TEST(Folder, job_file_lists_all_frames) {
  const TempDir dir;
  const Words whole = small_teapot("0-1", "a") + kWithCompanions;
  expect_done(dir, whole);
  expect_done(dir, {"check", "a"});
  const std::set<std::string> names = names_below(dir / "a");
  for (const std::string gone : {"single", "page", "single/frame_0001.png", "page/index.html", "film.mkv", "film_single.mkv"}) {
    ASSERT_TRUE(fs::exists(dir / "a" / gone)) << gone;
    fs::remove_all(dir / "a" / gone);
    const RunResult check = run_tool(dir, {"check", "a"});
    EXPECT_EQ(check.exit_code, 1) << gone;
    EXPECT_THAT(check.out, HasSubstr("missing  " + gone));
    expect_done(dir, {"render", "a/job.toml", "--resume", "--quiet"});
    EXPECT_EQ(names_below(dir / "a"), names) << gone;
    expect_done(dir, {"check", "a"});
  }
}

TEST(Folder, resuming_makes_missing_companions) {
  const TempDir dir;
  Subprocess killed(tool_command(small_teapot("0-3", "a") + kWithCompanions), {dir.path().string(), 0});
  ASSERT_TRUE(appears(dir / "a/frame_0001.png"));
  killed.signal(SIGKILL);
  killed.wait();
  EXPECT_EQ(run_tool(dir, {"check", "a"}).exit_code, 1);
  expect_done(dir, {"render", "a/job.toml", "--resume", "--quiet"});
  expect_done(dir, {"check", "a"});
  for (const char* name : {"single/frame_0003.png", "page/index.html", "film.mkv", "film_single.mkv"})
    EXPECT_TRUE(fs::exists(dir / "a" / name)) << name;
}

TEST(Folder, forced_render_removes_old_companions) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-1", "a") + kWithCompanions);
  std::ofstream(dir / "a/page/notes.txt") << "somebody's";
  expect_done(dir, small_teapot("0", "a") + Words{"--view-angle", "40", "--force"});
  EXPECT_EQ(names_below(dir / "a"), (std::set<std::string>{"frame_0000.png", "job.toml", "report.json", "page/notes.txt"}));
  EXPECT_FALSE(fs::exists(dir / "a/single"));
}

TEST(Folder, finishing_makes_the_companions) {
  const TempDir dir;
  const Words job = small_teapot("0-1", "a") + Words{"--also", "single", "--page"};
  expect_done(dir, job + Words{"--unit", "1/2"});
  EXPECT_EQ(run_tool(dir, {"finish", "a"}).exit_code, 1);
  expect_done(dir, job + Words{"--unit", "2/2"});
  EXPECT_FALSE(fs::exists(dir / "a/page"));
  fs::rename(dir / "a/single", dir / "kept");
  const RunResult finish = run_tool(dir, {"finish", "a"});
  EXPECT_EQ(finish.exit_code, 1);
  EXPECT_THAT(finish.out, HasSubstr("single"));
  fs::rename(dir / "kept", dir / "a/single");
  expect_done(dir, {"finish", "a"});
  EXPECT_TRUE(fs::exists(dir / "a/page/index.html"));
  expect_done(dir, {"check", "a"});
}

TEST(Folder, journal_has_every_file) {
  const TempDir dir;
  const Words views{"render", "teapot", "--optics", "multiview", "--views",      "2x2",
                    "--size", "32x32",  "--frames", "0",         "--camera-grid"};
  for (const Words& flags : {Words{"--layout", "quilt"}, Words{"--layout", "views", "--aov", "depth"},
                             Words{"--layout", "rgbd", "--video", "a/v.mkv"}, Words{"--to", "hci"}, Words{"--to", "miv"},
                             Words{"--to", "stanford"}}) {
    const RunResult made = run_tool(dir, views + flags + Words{"-o", "a"});
    if (made.exit_code != 0) {
      ADD_FAILURE() << flags[1] << made.err;
      continue;
    }
    for (const std::string& name : names_below(dir / "a")) {
      fs::rename(dir / "a" / name, dir / "kept");
      EXPECT_THAT(run_tool(dir, {"check", "a"}).out, HasSubstr("missing  " + name)) << flags[1];
      fs::rename(dir / "kept", dir / "a" / name);
    }
    fs::remove_all(dir / "a");
  }
}

TEST(Folder, copied_folder_is_resumed) {
  const TempDir dir;
  const std::string absolute = dir / "a";
  expect_done(dir, small_teapot("0-1", absolute) + Words{"--video", absolute + "/v.mkv"});
  fs::copy(dir / "a", dir / "b", fs::copy_options::recursive);
  fs::remove_all(dir / "a");
  fs::remove(dir / "b/frame_0001.png"), fs::remove(dir / "b/v.mkv");
  expect_done(dir, {"render", "b/job.toml", "--resume", "--quiet"});
  EXPECT_FALSE(fs::exists(dir / "a"));
  expect_done(dir, {"check", "b"});
}

TEST(Folder, later_run_extends_the_job_file) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "a") + Words{"--video", "a/v.mkv"});
  expect_done(dir, small_teapot("0", "a") + Words{"--resume", "--page"});
  expect_done(dir, small_teapot("0-1", "a") + Words{"--resume"});
  const std::string job = bytes_of(dir / "a/job.toml");
  for (const char* key : {"page = true", "v.mkv", "frames = \"0-1\""}) EXPECT_THAT(job, HasSubstr(key));
}

TEST(Folder, report_marks_frames_of_earlier_runs) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-1", "a"));
  EXPECT_EQ(json_of(bytes_of(dir / "a/report.json"))["resumed"], false);
  fs::remove(dir / "a/frame_0001.png");
  expect_done(dir, small_teapot("0-1", "a") + Words{"--resume"});
  EXPECT_EQ(json_of(bytes_of(dir / "a/report.json"))["resumed"], true);
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
                                   {"unfinished_beside", nlohmann::json::object()},
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

TEST(Folder, check_needs_a_render) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"check", "missing"}), 1, "missing: cannot be checked");
  fs::create_directory(dir / ".lippmann");
  std::ofstream(dir / ".lippmann/1.jsonl") << "{\"job\":\"a\"}\n{\"frame\":0}\n{\"asked\":\"0\"}\n";
  expect_refusal(run_tool(dir, {"check", "."}), 1, "line 2 of '1.jsonl' lacks");
  expect_refusal(run_tool(dir, {"render", "teapot", "--frames", "0", "-o", "."}), 1, "line 2 of '1.jsonl' lacks");
}

}  // namespace
}  // namespace lippmann::test

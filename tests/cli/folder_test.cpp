// One folder holds one render: what another one is told, what becomes of its files, and what a check finds.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const Words kOther{"--view-angle", "40"};

/// Every file below the folder, by its path in it.
Files all_files(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder)] = bytes_of(entry.path());
  return files;
}

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

TEST(Folder, same_command_twice_says_nothing_and_gives_the_same) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-1", "a"));
  const Files before = files_in(dir / "a", ".png");
  const RunResult again = run_tool(dir, small_teapot("0-1", "a") + Words{"--quiet"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.err, "");
  EXPECT_EQ(files_in(dir / "a", ".png"), before);
  expect_done(dir, {"check", "a"});
}

TEST(Folder, forced_render_leaves_no_layer_of_the_one_that_it_replaces) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-1", "a") + Words{"--aov", "depth"});
  ASSERT_TRUE(fs::exists(dir / "a/aov_0000.exr"));
  expect_done(dir, small_teapot("0", "a") + kOther + Words{"--force"});
  EXPECT_FALSE(fs::exists(dir / "a/aov_0000.exr"));
  EXPECT_FALSE(fs::exists(dir / "a/frame_0001.png"));
  expect_done(dir, {"check", "a"});
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

TEST(Folder, frames_of_one_job_accumulate_and_its_job_file_asks_for_all_of_them) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-3", "a"));
  expect_done(dir, small_teapot("4-5", "a"));
  EXPECT_THAT(bytes_of(dir / "a/job.toml"), HasSubstr("frames = \"0-5\"\n"));
  const std::string job = bytes_of(dir / "a/job.toml");
  expect_done(dir, {"render", "a/job.toml", "--frames", "2"});
  EXPECT_EQ(bytes_of(dir / "a/job.toml"), job);
  expect_done(dir, {"check", "a"});
  EXPECT_THAT(run_tool(dir, {"render", "a/job.toml", "--resume"}).out, HasSubstr("6 kept"));
}

TEST(Folder, job_file_that_somebody_wrote_is_never_rewritten) {
  const TempDir dir;
  fs::create_directory(dir / "a");
  const std::string job = "# mine\nscene = \"teapot\"\nlenses = 8\noutput = \".\"\nframes = \"0-1\"\n";
  std::ofstream(dir / "a/job.toml") << job;
  const RunResult whole = run_tool(dir, {"render", "a/job.toml", "--quiet"});
  EXPECT_EQ(whole.err, "");
  EXPECT_EQ(run_tool(dir, {"render", "a/job.toml", "--frames", "4-5", "--quiet"}).err, "");
  EXPECT_EQ(bytes_of(dir / "a/job.toml"), job);
  const RunResult forced = run_tool(dir, Words{"render", "a/job.toml", "--force", "--quiet"} + kOther);
  EXPECT_THAT(forced.err, HasSubstr("a/job.toml was not written by this render and stays, although it differs in view-angle"));
  EXPECT_EQ(bytes_of(dir / "a/job.toml"), job);
  expect_done(dir, {"check", "a"});
}

TEST(Folder, job_file_that_was_changed_by_hand_stays) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "a"));
  std::ofstream(dir / "a/job.toml", std::ios::app) << "spp = 1\n# mine\n";
  const std::string job = bytes_of(dir / "a/job.toml");
  expect_done(dir, small_teapot("1", "a") + Words{"--force"});
  EXPECT_EQ(bytes_of(dir / "a/job.toml"), job);
}

TEST(Folder, finished_video_is_not_overwritten_by_a_part_of_its_frames) {
  const TempDir dir;
  const Words whole = small_teapot("0-2", "a") + Words{"--video", "a/film.mkv"};
  expect_done(dir, whole);
  const Files before = all_files(dir / "a");
  expect_refusal(run_tool(dir, {"render", "a/job.toml", "--frames", "0"}), 1, "a/film.mkv: is finished and shows frames 0-2");
  EXPECT_EQ(all_files(dir / "a"), before);
  expect_done(dir, {"render", "a/job.toml", "--frames", "0", "--video", "first.mkv"});
  expect_done(dir, whole + Words{"--resume"});
  expect_done(dir, {"check", "a"});
  expect_done(dir, {"render", "a/job.toml", "--frames", "0", "--force"});
  EXPECT_LT(fs::file_size(dir / "a/film.mkv"), before.at("film.mkv").size());
}

TEST(Folder, video_that_the_render_has_not_written_is_not_overwritten) {
  const TempDir dir;
  std::ofstream(dir / "holiday.mkv") << "precious";
  const Words command = small_teapot("0", "a") + Words{"--video", "holiday.mkv"};
  expect_refusal(run_tool(dir, command), 1, "holiday.mkv: is there already");
  EXPECT_EQ(bytes_of(dir / "holiday.mkv"), "precious");
  EXPECT_FALSE(fs::exists(dir / "a"));
  expect_done(dir, command + Words{"--force"});
  EXPECT_NE(bytes_of(dir / "holiday.mkv"), "precious");
}

TEST(Folder, convert_does_not_read_a_layer_of_another_render) {
  const TempDir dir;
  const Words views{"render", "teapot", "--optics", "multiview", "--camera-grid", "--views", "2x2",
                    "--size", "32x32",  "--frames", "0"};
  expect_done(dir, views + Words{"-o", "deep", "--aov", "depth"});
  expect_done(dir, views + Words{"-o", "plain"});
  expect_done(dir, {"convert", "deep", "deep-hci", "--to", "hci"});
  ASSERT_TRUE(fs::exists(dir / "deep-hci/frame_0000/gt_depth_lowres_Cam000.pfm"));
  fs::copy_file(dir / "deep/aov_0000.exr", dir / "plain/aov_0000.exr");
  expect_done(dir, {"convert", "plain", "plain-hci", "--to", "hci"});
  EXPECT_FALSE(fs::exists(dir / "plain-hci/frame_0000/gt_depth_lowres_Cam000.pfm"));
  EXPECT_THAT(run_tool(dir, {"check", "plain"}).out, HasSubstr("foreign  aov_0000.exr"));
  EXPECT_THAT(run_tool(dir, views + Words{"-o", "plain", "--resume"}).err,
              HasSubstr("plain also holds files of no frame of this render, which stay: aov_0000.exr"));
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

TEST(Folder, views_are_not_written_through_a_symbolic_link) {
  const TempDir dir;
  fs::create_directory(dir / "a"), fs::create_directory(dir / "elsewhere");
  fs::create_directory_symlink(dir / "elsewhere", dir / "a/frame_0000");
  expect_refusal(run_tool(dir, small_teapot("0", "a") + Words{"--layout", "views", "--quiet"}), 1,
                 "a/frame_0000: is a symbolic");
  EXPECT_TRUE(fs::is_empty(dir / "elsewhere"));
}

/// Damages the file in some way.
using Damage = std::function<void(const fs::path& file)>;

void flip_a_bit(const fs::path& file) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  const auto middle = static_cast<std::streamoff>(fs::file_size(file) / 2);
  stream.seekg(middle);
  const int byte = stream.get();
  stream.seekp(middle);
  stream.put(static_cast<char>(byte ^ 1));
}

void write_zeros(const fs::path& file) {
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary) << std::string(fs::file_size(file), '\0');
}

TEST(Folder, damage_of_any_file_is_found_by_check_and_mended_by_resume) {
  const std::vector<Words> kinds{{"--lenses", "6", "--aov", "depth"},
                                 {"--lenses", "6", "--format", "tiff"},
                                 {"--lenses", "6", "--format", "exr"},
                                 {"--lenses", "6", "--layout", "views"},
                                 {"--optics", "multiview", "--views", "2x2", "--size", "32x32", "--layout", "quilt"}};
  const std::vector<Damage> damages{flip_a_bit, write_zeros, [](const fs::path& file) { fs::resize_file(file, 0); },
                                    [](const fs::path& file) { fs::remove(file); }};
  for (const Words& kind : kinds) {
    const TempDir dir;
    const Words command = Words{"render", "teapot", "--frames", "0", "-o", "a"} + kind;
    expect_done(dir, command);
    Files whole = all_files(dir / "a");
    for (const char* name : {"report.json", "job.toml"}) whole.erase(name);
    std::erase_if(whole, [](const auto& file) { return file.first.starts_with(".lippmann/"); });
    const std::string name = std::next(whole.begin(), static_cast<std::ptrdiff_t>(whole.size()) / 2)->first;
    for (std::size_t i = 0; i < damages.size(); ++i) {
      damages[i](dir / "a" / name);
      const RunResult check = run_tool(dir, {"check", "a"});
      EXPECT_EQ(check.exit_code, 1) << name << " " << i;
      EXPECT_THAT(check.out, HasSubstr((fs::exists(dir / "a" / name) ? "damaged  " : "missing  ") + name + "\n"));
      expect_done(dir, command + Words{"--resume"});
      EXPECT_EQ(bytes_of(dir / "a" / name), whole.at(name)) << name << " " << i;
      expect_done(dir, {"check", "a"});
    }
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
                                   {"passed", true}}));
  flip_a_bit(dir / "film.mkv");
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

TEST(Folder, check_of_a_stopped_render_says_which_frames_are_to_come) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-1", "a"));
  const fs::path journal = fs::directory_iterator(dir / "a/.lippmann")->path();
  std::ofstream(journal, std::ios::app) << R"({"asked":"0-5"})"
                                        << "\n";
  const RunResult check = run_tool(dir, {"check", "a"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_THAT(check.out, HasSubstr("not rendered yet: frames 2-5\n"));
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

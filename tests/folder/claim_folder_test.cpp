#include "folder/claim_folder.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <utility>

#include "folder/folder_check.hpp"
#include "folder/render_folder.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

void make_file(const fs::path& path, const std::string& bytes = "bytes") {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << bytes;
}

void make_render(const fs::path& folder, const std::string& job, const std::vector<int>& finished) {
  fs::create_directories(folder);
  RenderFolder journal(folder, job);
  journal.begin({0, 1, 2});
  for (const int frame : finished) {
    FrameReport report;
    report.frame = frame;
    const std::vector<fs::path> files{picture_paths(folder, {}, frame).front(),
                                      folder / ("aov_000" + std::to_string(frame) + ".exr")};
    for (const fs::path& file : files) make_file(file);
    journal.add(report, records_of(folder, files));
  }
  journal.write("report.json", [](const FolderJournal&) { return std::string("bytes"); });
}

void make_video(const fs::path& folder, const std::string& job, const fs::path& video, const std::vector<int>& frames) {
  make_file(video);
  RenderFolder(folder, job).add_video(video, frames);
}

fs::path part_of(const fs::path& folder) { return read_journal(folder)->parts.front(); }

std::string refusal(const fs::path& folder, const std::string& job, const std::vector<std::string>& videos = {},
                    const std::vector<int>& frames = {0, 1, 2}) {
  try {
    require_free_folder(folder, job, {}, frames, videos);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<std::string> cleared(const fs::path& folder, const std::string& job, bool force, const std::vector<int>& frames) {
  std::vector<std::string> warnings;
  Context context;
  context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  clear_folder(folder, {.job = job, .frames = frames, .force = force}, context);
  return warnings;
}

TEST(ClaimFolder, new_empty_and_same_job_folders_are_free) {
  const test::TempDir dir;
  EXPECT_EQ(refusal(dir / "missing", "a"), "");
  EXPECT_EQ(refusal(dir.path(), "a"), "");
  for (const char* name : {"notes.txt", "frame.png", "frames/frame_0000.png", "view_000.png", "photo_0001.png"})
    make_file(dir / name);
  EXPECT_EQ(refusal(dir.path(), "a"), "");
  make_render(dir.path(), "a", {0});
  EXPECT_EQ(refusal(dir.path(), "a"), "");
}

TEST(ClaimFolder, renders_with_frames_are_refused) {
  const test::TempDir dir;
  make_render(dir / "one", "a", {0});
  make_render(dir / "none", "a", {});
  EXPECT_THAT(refusal(dir / "one", "b"), testing::AllOf(HasSubstr("holds another render"), HasSubstr("`force`")));
  EXPECT_EQ(refusal(dir / "none", "b"), "");
}

/// Writes the journal of another machine's run without frames. Its final line is missing unless `has_ended`.
fs::path make_remote_run(const fs::path& folder, const std::string& job, bool has_ended = false) {
  fs::create_directories(folder / ".lippmann");
  const fs::path part = folder / ".lippmann/01700000000-elsewhere-7.jsonl";
  std::ofstream(part) << job_line(job) << asked_line({0, 1, 2}) << (has_ended ? run_line({}) : std::string());
  return part;
}

TEST(ClaimFolder, live_run_without_frames_refuses_other_jobs) {
  const test::TempDir dir;
  const fs::path folder = dir / "out";
  {
    fs::create_directory(folder);
    RenderFolder live(folder, "a");
    live.begin({0, 1, 2});
    EXPECT_THAT(refusal(folder, "b"), HasSubstr("another render has begun in it"));
    EXPECT_THROW(cleared(folder, "b", true, {0}), Error);
    EXPECT_THROW(RenderFolder(folder, "b"), Error);
    EXPECT_EQ(free_folder(folder, "b"), dir / "out-2");
    EXPECT_THROW(require_no_render(folder), Error);
    EXPECT_EQ(refusal(folder, "a"), "");
    EXPECT_NO_THROW(RenderFolder(folder, "a"));
    live.begin({3});  // the destructor of `live` releases the folder
  }
  EXPECT_EQ(refusal(folder, "b"), "");
  EXPECT_EQ(free_folder(folder, "b"), folder);
  cleared(folder, "b", false, {0});
  EXPECT_NO_THROW(RenderFolder(folder, "b"));
}

TEST(ClaimFolder, live_run_is_not_replaced_by_force) {
  const test::TempDir dir;
  make_render(dir.path(), "a", {0});
  {
    const RenderFolder live(dir.path(), "a");
    EXPECT_THROW(cleared(dir.path(), "b", true, {0}), Error);
    EXPECT_TRUE(fs::exists(dir / "frame_0000.png"));
  }
  cleared(dir.path(), "b", true, {0});
  EXPECT_FALSE(fs::exists(dir / "frame_0000.png"));
}

TEST(ClaimFolder, remote_run_holds_the_folder_during_its_lease) {
  const test::TempDir dir;
  const fs::path part = make_remote_run(dir.path(), "a");
  EXPECT_THAT(refusal(dir.path(), "b"), HasSubstr("process 7 on elsewhere"));
  EXPECT_EQ(refusal(dir.path(), "a"), "");
  fs::last_write_time(part, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(refusal(dir.path(), "b"), "");
  make_remote_run(dir.path(), "a", true);
  EXPECT_EQ(refusal(dir.path(), "b"), "");
}

TEST(ClaimFolder, replacing_keeps_the_journal_of_the_new_run) {
  const test::TempDir dir;
  make_render(dir.path(), "a", {0});
  RenderFolder run(dir.path(), "b", [&](const fs::path& own) {
    clear_folder(dir.path(), {.job = "b", .frames = {0}, .force = true, .own = own}, {});
  });
  EXPECT_EQ(read_journal(dir.path())->job, "b");
  EXPECT_TRUE(run.before().frames.empty());
  EXPECT_FALSE(fs::exists(dir / "frame_0000.png"));
}

TEST(ClaimFolder, kill_while_making_room_keeps_the_old_render) {
  const test::TempDir dir;
  make_render(dir.path(), "a", {0});
  const fs::path part = make_remote_run(dir.path(), "b");
  fs::last_write_time(part, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(refusal(dir.path(), "a"), "");
  EXPECT_THAT(refusal(dir.path(), "b"), HasSubstr("holds another render"));
  cleared(dir.path(), "a", false, {0});
  EXPECT_FALSE(fs::exists(part));
  EXPECT_TRUE(fs::exists(dir / "frame_0000.png"));
}

/// Becomes an unprivileged user who owns the files, because root ignores permissions.
class WithoutRoot {
 public:
  explicit WithoutRoot(const fs::path& folder) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() != 0) return;
    is_owner_ = chown(folder.c_str(), kNobody, static_cast<gid_t>(-1)) == 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      is_owner_ = is_owner_ && chown(entry.path().c_str(), kNobody, static_cast<gid_t>(-1)) == 0;
    is_owner_ = is_owner_ && seteuid(kNobody) == 0;
    was_root_ = true;
  }
  ~WithoutRoot() {
    if (was_root_) is_owner_ = seteuid(0) == 0;
  }
  WithoutRoot(const WithoutRoot&) = delete;
  WithoutRoot& operator=(const WithoutRoot&) = delete;

  bool is_owner() const { return is_owner_; }

 private:
  bool was_root_ = false, is_owner_ = true;
};

TEST(ClaimFolder, unremovable_file_is_an_error) {
  const test::TempDir dir;
  make_render(dir / "a", "a", {0});
  const WithoutRoot nobody(dir.path());
  ASSERT_TRUE(nobody.is_owner());
  fs::permissions(dir / "a", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(test::error_message([&] { cleared(dir / "a", "b", true, {0}); }),
              HasSubstr("cannot be removed (Permission denied)"));
  fs::permissions(dir / "a", fs::perms::owner_all);
}

TEST(ClaimFolder, unrecorded_pictures_and_reports_are_refused) {
  const test::TempDir dir;
  for (const char* name :
       {"frame_0000.png", "aov_0007.exr", "frame_0003/view_000.png", "frame_0000_qs8x6a1.png.json", "report.json"}) {
    make_file(dir / "a" / name);
    EXPECT_THAT(refusal(dir / "a", "job"), HasSubstr(name));
    fs::remove_all(dir / "a");
  }
}

TEST(ClaimFolder, damaged_journal_is_refused) {
  const test::TempDir dir;
  make_render(dir.path(), "a", {0});
  std::ofstream(part_of(dir.path()), std::ios::app) << "{\"frame\":\n{}\n";
  EXPECT_THAT(refusal(dir.path(), "a"), testing::AllOf(HasSubstr("is damaged"), HasSubstr("`force`")));
}

TEST(ClaimFolder, fifo_is_an_error_without_waiting) {
  for (const char* name : {"job.toml", "report.json", ".lippmann/1.jsonl"}) {
    const test::TempDir dir;
    fs::create_directory(dir / ".lippmann");
    ASSERT_EQ(mkfifo((dir / name).c_str(), 0600), 0);
    EXPECT_THAT(refusal(dir.path(), "a"), HasSubstr("is not a regular file but a FIFO")) << name;
  }
}

TEST(ClaimFolder, default_folder_is_the_first_free_one) {
  const test::TempDir dir;
  const fs::path wanted = dir / "out";
  EXPECT_EQ(free_folder(wanted, "a"), wanted);
  make_render(wanted, "a", {0});
  EXPECT_EQ(free_folder(wanted, "a"), wanted);
  EXPECT_EQ(free_folder(wanted, "b"), dir / "out-2");
  make_render(dir / "out-2", "b", {0});
  make_file(dir / "out-3/frame_0000.png");
  EXPECT_EQ(free_folder(wanted, "b"), dir / "out-2");
  EXPECT_EQ(free_folder(wanted, "c"), dir / "out-4");
}

TEST(ClaimFolder, existing_videos_of_others_are_refused) {
  const test::TempDir dir;
  const fs::path folder = dir / "a";
  make_render(folder, "a", {0, 1, 2});
  make_file(dir / "b.mp4");
  make_video(folder, "a", dir / "a.mp4", {0, 1, 2});
  EXPECT_EQ(refusal(folder, "a", {dir / "new.mp4"}), "");
  EXPECT_THAT(refusal(folder, "a", {dir / "b.mp4"}), HasSubstr("has not written it"));
  EXPECT_THAT(refusal(dir / "c", "c", {dir / "a.mp4"}), HasSubstr("has not written it"));
  EXPECT_EQ(refusal(folder, "a", {dir / "a.mp4"}), "");
  EXPECT_EQ(refusal(folder, "a", {dir / "a.mp4"}, {0, 1, 2, 3}), "");
  EXPECT_THAT(refusal(folder, "a", {dir / "a.mp4"}, {0}), testing::AllOf(HasSubstr("frames 0-2"), HasSubstr("`force`")));
}

TEST(ClaimFolder, single_views_video_outlives_its_folder) {
  const test::TempDir dir;
  const fs::path whole = dir / "a", single = whole / kSingleFolder;
  make_render(whole, "a", {0, 1, 2});
  RenderFolder(whole, "a").begin({0, 1, 2}, {kSingleFolder});
  make_render(single, "s", {0, 1, 2});
  for (const auto& [folder, job] : {std::pair(whole, "a"), std::pair(single, "s")})
    make_video(folder, job, whole / "film_single.mkv", {0, 1, 2});
  make_file(whole / "somebodys_single.mkv");
  fs::remove(whole / "film_single.mkv");
  EXPECT_THAT(check_folder(whole).missing, ElementsAre("film_single.mkv"));
  make_file(whole / "film_single.mkv");
  fs::remove_all(single);
  EXPECT_EQ(refusal(single, "s", {whole / "film_single.mkv"}), "");
  EXPECT_THAT(refusal(single, "s", {whole / "somebodys_single.mkv"}), HasSubstr("has not written it"));
  EXPECT_THAT(refusal(dir / "single", "s", {whole / "film_single.mkv"}), HasSubstr("has not written it"));
}

TEST(ClaimFolder, replacing_removes_only_recorded_files) {
  const test::TempDir dir;
  const fs::path folder = dir / "a";
  make_render(folder, "a", {0, 1});
  make_video(folder, "a", folder / "inside.mp4", {0});
  make_video(folder, "a", dir / "outside.mp4", {0});
  make_video(folder, "a", folder / "cut.mp4", {0});
  make_file(folder / "cut.mp4", "cut by hand");
  for (const char* name : {"notes.txt", "aov_0001.png", "aov_0002.exr", "job.toml"}) make_file(folder / name);
  EXPECT_THAT(cleared(folder, "b", true, {2}), ElementsAre(HasSubstr("are kept: aov_0001.png")));
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder)) left.push_back(entry.path().filename());
  EXPECT_THAT(left, testing::UnorderedElementsAre("notes.txt", "aov_0001.png", "job.toml", "cut.mp4"));
  EXPECT_TRUE(fs::exists(dir / "outside.mp4"));
}

TEST(ClaimFolder, foreign_files_stay_with_a_warning_unless_forced) {
  const test::TempDir dir;
  make_render(dir.path(), "a", {0});
  make_file(dir / "aov_0000.png");
  make_file(dir / "frame_0001.png");
  EXPECT_THAT(cleared(dir.path(), "a", false, {0, 1, 2}), ElementsAre(HasSubstr("aov_0000.png")));
  EXPECT_TRUE(fs::exists(dir / "aov_0000.png"));
  EXPECT_THAT(cleared(dir.path(), "a", true, {0, 1, 2}), ElementsAre());
  EXPECT_FALSE(fs::exists(dir / "aov_0000.png"));
  EXPECT_TRUE(fs::exists(dir / "frame_0001.png"));
}

TEST(ClaimFolder, nothing_is_removed_through_symbolic_links) {
  const test::TempDir dir;
  const fs::path folder = dir / "a";
  make_file(folder / "frame_0000/view_000.png");
  make_file(dir / "target.png");
  fs::create_symlink(dir / "target.png", folder / "frame_0001.png");
  {
    RenderFolder journal(folder, "a");
    FrameReport report;
    journal.add(report, records_of(folder, {folder / "frame_0000/view_000.png"}));
    report.frame = 1;
    journal.add(report, records_of(folder, {folder / "frame_0001.png"}));
  }
  fs::rename(folder / "frame_0000", dir / "elsewhere");
  fs::create_directory_symlink(dir / "elsewhere", folder / "frame_0000");
  cleared(folder, "b", true, {0, 1});
  EXPECT_TRUE(fs::exists(dir / "elsewhere/view_000.png"));
  EXPECT_TRUE(fs::exists(dir / "target.png"));
  EXPECT_FALSE(fs::is_symlink(folder / "frame_0001.png"));
}

TEST(ClaimFolder, hostile_journals_remove_nothing_outside) {
  const test::TempDir dir;
  const fs::path folder = dir / "a";
  make_render(folder, "a", {0});
  for (const char* name : {"../victim", "../frame_0001.png", "notes.txt"}) make_file(folder / name);
  const std::string absolute = dir / "frame_0001.png";
  for (const std::string& name :
       {std::string("../victim"), std::string("../frame_0001.png"), std::string("notes.txt"), absolute}) {
    FrameReport report;
    report.frame = 1;
    std::ofstream(part_of(folder), std::ios::app) << frame_line(report, {{name, *file_checksum(folder / "frame_0000.png")}});
  }
  std::ofstream(part_of(folder), std::ios::app) << asked_line({0});
  EXPECT_THROW(check_folder(folder), Error);
  cleared(folder, "b", true, {0, 1, 2});
  for (const char* name : {"../victim", "../frame_0001.png", "notes.txt"}) EXPECT_TRUE(fs::exists(folder / name)) << name;
  EXPECT_FALSE(fs::exists(folder / "frame_0000.png"));
}

TEST(CheckFolder, whole_render_passes) {
  const test::TempDir dir;
  make_render(dir / "a", "a", {0, 1, 2});
  make_video(dir / "a", "a", dir / "a.mp4", {0, 1, 2});
  make_file(dir / "a/notes.txt");
  const FolderCheck check = check_folder(dir / "a");
  EXPECT_TRUE(check.passed());
  EXPECT_EQ(check.frames, 3);
  EXPECT_EQ(check.files, 8u);
}

TEST(CheckFolder, finds_damaged_missing_foreign_and_unrendered_files) {
  const test::TempDir dir;
  const fs::path folder = dir / "a";
  make_render(folder, "a", {0, 1});
  make_video(folder, "a", dir / "a.mp4", {0, 1, 2});
  make_file(folder / "frame_0000.png", "bytfs");
  fs::remove(folder / "aov_0000.exr");
  fs::remove(folder / "aov_0001.exr");
  ASSERT_EQ(mkfifo((folder / "aov_0001.exr").c_str(), 0600), 0);
  make_file(dir / "a.mp4", "");
  make_file(folder / "report.json", "{}");
  make_file(folder / "frame_0001_qs8x6a1.png");
  make_file(folder / "frame_0002.png");
  const FolderCheck check = check_folder(folder);
  EXPECT_THAT(check.damaged, ElementsAre("frame_0000.png", "aov_0001.exr", "report.json", "../a.mp4"));
  EXPECT_THAT(check.missing, ElementsAre("aov_0000.exr"));
  EXPECT_THAT(check.foreign, ElementsAre("frame_0001_qs8x6a1.png"));
  EXPECT_THAT(check.unfinished, ElementsAre(2));
  EXPECT_FALSE(check.passed());
}

TEST(CheckFolder, folder_without_a_render_is_an_error) {
  const test::TempDir dir;
  make_file(dir / "frame_0000.png");
  EXPECT_THROW(check_folder(dir.path()), Error);
  EXPECT_THROW(check_folder(dir / "missing"), Error);
}

}  // namespace
}  // namespace lippmann

#include "folder/join_folders.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "folder/folder_check.hpp"
#include "folder/render_folder.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

void make_part(const fs::path& folder, const std::string& job, const std::vector<int>& frames) {
  fs::create_directories(folder);
  RenderFolder part(folder, job);
  part.begin(frames);
  FrameNames names;
  names.views = 2;
  for (const int frame : frames) {
    FrameReport report;
    report.frame = frame;
    report.seconds = frame;
    const std::vector<fs::path> files = picture_paths(folder, names, frame);
    for (const fs::path& file : files) {
      fs::create_directories(file.parent_path());
      std::ofstream(file) << "view of frame " << frame;
    }
    part.add(report, records_of(folder, files));
  }
  RunReport run;
  run.unit = "1/2", run.frames = frames;
  part.end(run);
}

TEST(JoinFolders, frames_are_copied_with_their_figures) {
  const test::TempDir dir;
  make_part(dir / "a", "job", {0, 1});
  make_part(dir / "b", "job", {1, 2, 3});
  const JoinedFolders joined = join_folders(dir / "all", {dir / "a", dir / "b"});
  EXPECT_THAT(joined.frames, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(joined.not_as_written, IsEmpty());
  const FolderCheck check = check_folder(dir / "all");
  EXPECT_TRUE(check.passed());
  EXPECT_EQ(check.frames, 4);
  EXPECT_EQ(read_journal(dir / "all")->frames.at(3).report.seconds, 3.0);
  EXPECT_EQ(read_journal(dir / "all")->runs.size(), 2u);
  for (const char* part : {"a", "b"}) EXPECT_TRUE(check_folder(dir / part).passed());
}

TEST(JoinFolders, joining_again_copies_only_missing_frames) {
  const test::TempDir dir;
  make_part(dir / "a", "job", {0, 1});
  make_part(dir / "b", "job", {1, 2});
  EXPECT_THAT(join_folders(dir / "a", {dir / "b"}).frames, ElementsAre(2));
  EXPECT_THAT(join_folders(dir / "a", {dir / "b"}).frames, IsEmpty());
  EXPECT_TRUE(check_folder(dir / "a").passed());
}

TEST(JoinFolders, damaged_frames_are_named_and_replaced) {
  const test::TempDir dir;
  make_part(dir / "a", "job", {0, 1});
  make_part(dir / "b", "job", {0, 1});
  std::ofstream(dir / "a/frame_0001/view_001.png") << "other bytes";
  const JoinedFolders joined = join_folders(dir / "all", {dir / "a"});
  EXPECT_THAT(joined.frames, ElementsAre(0));
  EXPECT_THAT(joined.not_as_written, ElementsAre((dir / "a/frame_0001/view_001.png").string()));
  EXPECT_THAT(check_folder(dir / "all").unfinished, ElementsAre(1));
  EXPECT_THAT(join_folders(dir / "a", {dir / "b"}).frames, ElementsAre(1));
  EXPECT_TRUE(check_folder(dir / "a").passed());
}

TEST(JoinFolders, other_jobs_are_refused_before_copying) {
  const test::TempDir dir;
  make_part(dir / "a", "job", {0});
  make_part(dir / "b", "another", {1});
  fs::create_directory(dir / "empty");
  EXPECT_THROW(join_folders(dir / "all", {dir / "a", dir / "b"}), Error);
  EXPECT_THROW(join_folders(dir / "all", {dir / "a", dir / "empty"}), Error);
  EXPECT_THROW(join_folders(dir / "a", {dir / "a"}), Error);
  EXPECT_FALSE(fs::exists(dir / "all"));
}

}  // namespace
}  // namespace lippmann

#include "folder/render_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "folder/folder_check.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

const FrameNames kPng{};

void make_picture(const test::TempDir& dir, int frame, const std::string& bytes = "picture") {
  std::ofstream(picture_paths(dir.path(), kPng, frame).front()) << bytes;
}

FileRecords files_of(const test::TempDir& dir, int frame) {
  return records_of(dir.path(), picture_paths(dir.path(), kPng, frame));
}

FrameReport report_of(int frame) {
  FrameReport report;
  report.frame = frame;
  report.seconds = 0.25;
  report.rays.primary = 100;
  return report;
}

TEST(RenderFolder, recorded_frame_is_found_with_its_figures) {
  const test::TempDir dir;
  make_picture(dir, 4);
  RenderFolder(dir.path(), "job-a").add(report_of(4), files_of(dir, 4));
  RenderFolder again(dir.path(), "job-a");
  ASSERT_TRUE(again.find(4).has_value());
  EXPECT_EQ(again.find(4)->seconds, 0.25);
  EXPECT_EQ(again.find(4)->rays.primary, 100u);
  EXPECT_FALSE(again.find(5).has_value());
}

TEST(RenderFolder, recorded_path_traced_frame_keeps_its_errors) {
  const test::TempDir dir;
  make_picture(dir, 4);
  FrameReport traced = report_of(4);
  traced.estimated_psnr_db = 40.5, traced.psnr_at_least_db = 39.25, traced.psnr_at_most_db = 42.75;
  RenderFolder(dir.path(), "job-a").add(traced, files_of(dir, 4));
  const auto found = RenderFolder(dir.path(), "job-a").find(4);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->estimated_psnr_db, 40.5);
  EXPECT_EQ(found->psnr_at_least_db, 39.25);
  EXPECT_EQ(found->psnr_at_most_db, 42.75);
}

TEST(RenderFolder, another_job_is_refused_and_changes_nothing) {
  const test::TempDir dir;
  make_picture(dir, 4);
  RenderFolder(dir.path(), "job-a").add(report_of(4), files_of(dir, 4));
  EXPECT_THROW(RenderFolder(dir.path(), "job-b"), Error);
  EXPECT_TRUE(RenderFolder(dir.path(), "job-a").find(4).has_value());
}

TEST(RenderFolder, concurrent_renders_are_all_recorded) {
  const test::TempDir dir;
  for (const int frame : {1, 2, 3}) make_picture(dir, frame);
  RenderFolder one(dir.path(), "job");
  one.add(report_of(1), files_of(dir, 1));
  RenderFolder other(dir.path(), "job");
  one.add(report_of(2), files_of(dir, 2));
  other.add(report_of(3), files_of(dir, 3));
  RenderFolder both(dir.path(), "job");
  for (const int frame : {1, 2, 3}) EXPECT_TRUE(both.find(frame).has_value()) << frame;
}

TEST(RenderFolder, missing_or_resized_pictures_are_unfinished) {
  const test::TempDir dir;
  make_picture(dir, 1);
  make_picture(dir, 2);
  {
    RenderFolder finished(dir.path(), "job");
    finished.add(report_of(1), files_of(dir, 1));
    finished.add(report_of(2), files_of(dir, 2));
  }
  std::filesystem::remove(picture_paths(dir.path(), kPng, 1).front());
  make_picture(dir, 2, "cut");
  RenderFolder again(dir.path(), "job");
  EXPECT_FALSE(again.find(1).has_value());
  EXPECT_FALSE(again.find(2).has_value());
}

TEST(RenderFolder, changed_or_irregular_files_are_unfinished) {
  const test::TempDir dir;
  const auto layer = [&](int frame) { return dir / ("aov_000" + std::to_string(frame) + ".exr"); };
  {
    RenderFolder finished(dir.path(), "job");
    for (const int frame : {1, 2, 3, 4}) {
      make_picture(dir, frame);
      std::ofstream(layer(frame)) << "layer";
      finished.add(report_of(frame), records_of(dir.path(), {picture_paths(dir.path(), kPng, frame).front(), layer(frame)}));
    }
  }
  make_picture(dir, 1, "pixture");
  std::filesystem::remove(layer(2));
  std::filesystem::remove(layer(3));
  ASSERT_EQ(mkfifo(layer(3).c_str(), 0600), 0);
  const FolderCheck check = check_folder(dir.path());
  EXPECT_EQ(check.damaged, (std::vector<std::string>{"frame_0001.png", "aov_0003.exr"}));
  EXPECT_EQ(check.missing, std::vector<std::string>{"aov_0002.exr"});
  RenderFolder again(dir.path(), "job");
  for (const int frame : {1, 2, 3}) EXPECT_FALSE(again.find(frame).has_value()) << frame;
  EXPECT_TRUE(again.find(4).has_value());
}

TEST(RenderFolder, torn_last_line_is_ignored) {
  const test::TempDir dir;
  for (const int frame : {1, 2, 3}) make_picture(dir, frame);
  {
    RenderFolder folder(dir.path(), "job");
    folder.add(report_of(1), files_of(dir, 1));
    folder.add(report_of(2), files_of(dir, 2));
  }
  const auto part = read_journal(dir.path())->parts.front();
  std::filesystem::resize_file(part, std::filesystem::file_size(part) - 20);
  RenderFolder(dir.path(), "job").add(report_of(3), files_of(dir, 3));
  RenderFolder again(dir.path(), "job");
  EXPECT_TRUE(again.find(1).has_value());
  EXPECT_FALSE(again.find(2).has_value());
  EXPECT_TRUE(again.find(3).has_value());
}

TEST(RenderFolder, runs_keep_the_files_of_others) {
  const test::TempDir dir;
  make_picture(dir, 1);
  RenderFolder one(dir.path(), "job");
  one.add(report_of(1), files_of(dir, 1));
  const auto part = read_journal(dir.path())->parts.front();
  const std::optional<FileChecksum> before = file_checksum(part);
  RenderFolder other(dir.path(), "job");
  other.begin({1, 2});
  other.write("report.json", [](const FolderJournal&) { return std::string("{}"); });
  other.end({});
  EXPECT_EQ(file_checksum(part), before);
  EXPECT_EQ(other.now().parts.size(), 2u);
}

// `other` records a frame while `one` writes the report, so `one` must write the report again with both frames.
TEST(RenderFolder, shared_file_is_rewritten_after_concurrent_records) {
  const test::TempDir dir;
  for (const int frame : {1, 2}) make_picture(dir, frame);
  RenderFolder one(dir.path(), "job"), other(dir.path(), "job");
  one.add(report_of(1), files_of(dir, 1));
  int written = 0;
  const auto text_of = [&](const FolderJournal& journal) {
    if (++written == 1) other.add(report_of(2), files_of(dir, 2));
    return std::to_string(journal.frames.size()) + " frames";
  };
  one.write("report.json", text_of);
  std::string text;
  std::getline(std::ifstream(dir / "report.json"), text);
  EXPECT_EQ(text, "2 frames");
  EXPECT_EQ(written, 3);
  EXPECT_TRUE(is_as_written(one.now(), dir.path(), "report.json"));
}

TEST(RenderFolder, ended_runs_are_found_with_their_cost) {
  const test::TempDir dir;
  RenderFolder folder(dir.path(), "job");
  RunReport run;
  run.setup_seconds = 0.5, run.write_seconds = 1.25, run.peak_memory_bytes = 1u << 20, run.threads = 3;
  run.sources = {report_of(7)};
  folder.end(run);
  const std::vector<RunReport> runs = read_journal(dir.path())->runs;
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].setup_seconds, 0.5);
  EXPECT_EQ(runs[0].write_seconds, 1.25);
  EXPECT_EQ(runs[0].peak_memory_bytes, 1u << 20);
  EXPECT_EQ(runs[0].threads, 3);
  ASSERT_EQ(runs[0].sources.size(), 1u);
  EXPECT_EQ(runs[0].sources[0].frame, 7);
}

}  // namespace
}  // namespace lippmann

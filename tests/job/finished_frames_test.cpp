#include "job/finished_frames.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "job/folder_check.hpp"
#include "job/frame_files.hpp"
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

TEST(FinishedFrames, recorded_frame_is_found_by_the_same_job_with_its_figures) {
  const test::TempDir dir;
  make_picture(dir, 4);
  FinishedFrames(dir.path(), "job-a", kPng).add(report_of(4), files_of(dir, 4));
  FinishedFrames again(dir.path(), "job-a", kPng);
  ASSERT_TRUE(again.find(4).has_value());
  EXPECT_EQ(again.find(4)->seconds, 0.25);
  EXPECT_EQ(again.find(4)->rays.primary, 100u);
  EXPECT_FALSE(again.find(5).has_value());
}

TEST(FinishedFrames, recorded_frame_that_shares_light_is_found_with_its_errors) {
  const test::TempDir dir;
  make_picture(dir, 4);
  FrameReport shared = report_of(4);
  shared.kind = "shared";
  shared.estimated_psnr_db = 40.5, shared.psnr_at_least_db = 39.25, shared.estimated_block_psnr_db = 55.75;
  FinishedFrames(dir.path(), "job-a", kPng).add(shared, files_of(dir, 4));
  const auto found = FinishedFrames(dir.path(), "job-a", kPng).find(4);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->kind, "shared");
  EXPECT_EQ(found->estimated_psnr_db, 40.5);
  EXPECT_EQ(found->psnr_at_least_db, 39.25);
  EXPECT_EQ(found->estimated_block_psnr_db, 55.75);
}

TEST(FinishedFrames, another_job_is_refused_and_changes_nothing) {
  const test::TempDir dir;
  make_picture(dir, 4);
  FinishedFrames(dir.path(), "job-a", kPng).add(report_of(4), files_of(dir, 4));
  EXPECT_THROW(FinishedFrames(dir.path(), "job-b", kPng), Error);
  EXPECT_TRUE(FinishedFrames(dir.path(), "job-a", kPng).find(4).has_value());
}

TEST(FinishedFrames, renders_of_parts_that_run_beside_each_other_are_all_recorded) {
  const test::TempDir dir;
  for (const int frame : {1, 2, 3}) make_picture(dir, frame);
  FinishedFrames one(dir.path(), "job", kPng);
  one.add(report_of(1), files_of(dir, 1));
  FinishedFrames other(dir.path(), "job", kPng);
  one.add(report_of(2), files_of(dir, 2));
  other.add(report_of(3), files_of(dir, 3));
  FinishedFrames both(dir.path(), "job", kPng);
  for (const int frame : {1, 2, 3}) EXPECT_TRUE(both.find(frame).has_value()) << frame;
}

TEST(FinishedFrames, picture_gone_or_of_another_size_is_not_finished) {
  const test::TempDir dir;
  make_picture(dir, 1);
  make_picture(dir, 2);
  {
    FinishedFrames finished(dir.path(), "job", kPng);
    finished.add(report_of(1), files_of(dir, 1));
    finished.add(report_of(2), files_of(dir, 2));
  }
  std::filesystem::remove(picture_paths(dir.path(), kPng, 1).front());
  make_picture(dir, 2, "cut");
  FinishedFrames again(dir.path(), "job", kPng);
  EXPECT_FALSE(again.find(1).has_value());
  EXPECT_FALSE(again.find(2).has_value());
}

TEST(FinishedFrames, picture_or_layer_of_other_bytes_or_no_regular_file_is_not_finished) {
  const test::TempDir dir;
  const auto layer = [&](int frame) { return dir / ("aov_000" + std::to_string(frame) + ".exr"); };
  {
    FinishedFrames finished(dir.path(), "job", kPng);
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
  FinishedFrames again(dir.path(), "job", kPng);
  for (const int frame : {1, 2, 3}) EXPECT_FALSE(again.find(frame).has_value()) << frame;
  EXPECT_TRUE(again.find(4).has_value());
}

TEST(FinishedFrames, torn_last_line_is_forgotten_and_does_not_spoil_the_next) {
  const test::TempDir dir;
  for (const int frame : {1, 2, 3}) make_picture(dir, frame);
  {
    FinishedFrames finished(dir.path(), "job", kPng);
    finished.add(report_of(1), files_of(dir, 1));
    finished.add(report_of(2), files_of(dir, 2));
  }
  const auto journal = dir / ".lippmann-frames.jsonl";
  std::filesystem::resize_file(journal, std::filesystem::file_size(journal) - 20);
  FinishedFrames(dir.path(), "job", kPng).add(report_of(3), files_of(dir, 3));
  FinishedFrames again(dir.path(), "job", kPng);
  EXPECT_TRUE(again.find(1).has_value());
  EXPECT_FALSE(again.find(2).has_value());
  EXPECT_TRUE(again.find(3).has_value());
}

TEST(JobFingerprint, differs_for_what_changes_pictures_and_for_nothing_else) {
  const Scene scene;
  RenderParams params;
  const std::string same = job_fingerprint(params, scene);
  RenderParams elsewhere = params;
  elsewhere.output.folder = "elsewhere";
  elsewhere.threads = 7;
  elsewhere.output.frames = FrameRanges{{0, 1}};
  elsewhere.output.video = {"a.mp4"};
  elsewhere.resume = true;
  elsewhere.sampling.order = RayOrder::kRows;
  EXPECT_EQ(job_fingerprint(elsewhere, scene), same);
  RenderParams finer = params;
  finer.sampling.spp = 2;
  EXPECT_NE(job_fingerprint(finer, scene), same);
  Scene darker;
  darker.background.horizon = Vec3f(0.5f);
  EXPECT_NE(job_fingerprint(params, darker), same);
}

}  // namespace
}  // namespace lippmann

#include "job/frame_costs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace lippmann::test {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::vector<int> frames_from(int first, int count) {
  std::vector<int> frames(static_cast<std::size_t>(count));
  std::iota(frames.begin(), frames.end(), first);
  return frames;
}

FrameReport made(int frame, double cpu_seconds, const char* kind = "full") {
  FrameReport report;
  report.frame = frame, report.cpu_seconds = cpu_seconds, report.kind = kind;
  return report;
}

TEST(JobCosts, three_segments_are_measured) {
  EXPECT_THAT(frames_to_measure(frames_from(8, 40), 16, Neighbours::kOthers), ElementsAre(8, 9, 16, 17, 32, 33));
  EXPECT_THAT(frames_to_measure(frames_from(0, 48), 8, Neighbours::kCopied), ElementsAre(0, 1, 24, 25, 40, 41));
}

TEST(JobCosts, single_frames_are_measured_at_three) {
  EXPECT_THAT(frames_to_measure(frames_from(0, 60), 1, Neighbours::kOthers), ElementsAre(0, 30, 59));
  EXPECT_THAT(frames_to_measure(frames_from(0, 60), 1, Neighbours::kCopied), ElementsAre(0, 1, 30, 31, 58, 59));
  EXPECT_THAT(frames_to_measure({7}, 1, Neighbours::kCopied), ElementsAre(7));
}

TEST(JobCosts, first_frames_files_and_set_up_count) {
  MeasuredRun run{{made(0, 3.0), made(1, 1.0), made(8, 5.0), made(9, 2.0)}, {}, 0.5, 12.5, 77};
  const JobCosts costs = frame_costs(run, frames_from(0, 16), 8);
  EXPECT_THAT(costs.at, ElementsAre(Pair(0, 4.0), Pair(1, 1.5)));
  EXPECT_DOUBLE_EQ(costs.write_cpu_seconds, 0.25);  // (12.5 s in total - 0.5 s of set-up - 11 s of rendering) / 4 frames
  EXPECT_EQ(costs.peak_memory_bytes, 77u);
  EXPECT_THAT(costs.frames, ElementsAre(0, 1, 8, 9));
  EXPECT_DOUBLE_EQ(cpu_seconds_of(frames_from(0, 16), 8, costs), 0.5 + 2 * 4.0 + 14 * 1.5 + 16 * 0.25);
}

TEST(JobCosts, keys_of_copies_count_for_sixteen_frames) {
  const MeasuredRun run{
      {made(0, 1.0), made(1, 9.0, "key"), made(30, 9.0, "key"), made(31, 1.0, "in-between")}, {}, 0.0, 20.0, 0};
  // A frame takes 1 s. A key frame takes 8 s more, which count as 8 / 16 s for each frame.
  EXPECT_DOUBLE_EQ(frame_costs(run, frames_from(0, 60), 1).at.at(0), 1.5);
  const MeasuredRun only_a_key{{made(0, 9.0, "key")}, {}, 0.0, 9.0, 0};
  EXPECT_DOUBLE_EQ(frame_costs(only_a_key, {0}, 1).at.at(0), 9.0);
}

TEST(JobCosts, sources_exclude_later_frames_of_the_unit) {
  // Frames 0, 1, 8 and 9 are measured. They also need the frames 2, 4 and 16. Frames 2 and 4 belong to the job, which renders
  // them anyway. Only frame 16, outside the job, is an additional cost.
  const MeasuredRun run{
      {made(0, 1.0), made(1, 1.0), made(8, 1.0), made(9, 1.0)}, {made(2, 4.0), made(4, 4.0), made(16, 6.0)}, 0.0, 18.0, 0};
  const JobCosts costs = frame_costs(run, frames_from(0, 16), 8);
  EXPECT_DOUBLE_EQ(costs.source_cpu_seconds, 3.0);  // 6 s for frame 16, divided by two groups of 8 frames
  EXPECT_DOUBLE_EQ(costs.write_cpu_seconds, 0.0);
}

TEST(JobCosts, sources_include_frames_before_the_job) {
  const MeasuredRun run{{made(14, 1.0)}, {made(12, 2.0), made(13, 2.0)}, 0.0, 5.0, 0};
  EXPECT_DOUBLE_EQ(frame_costs(run, {14}, 16).source_cpu_seconds, 4.0);
}

TEST(JobCosts, unmeasured_frames_use_the_previous_measurement) {
  const MeasuredRun run{{made(2, 3.0), made(3, 2.0), made(8, 1.0)}, {}, 0.0, 6.0, 0};
  const JobCosts costs = frame_costs(run, frames_from(0, 16), 16);
  EXPECT_DOUBLE_EQ(cpu_seconds_of({0}, 16, costs), 3.0);
  EXPECT_DOUBLE_EQ(cpu_seconds_of({7}, 16, costs), 2.0);
  EXPECT_DOUBLE_EQ(cpu_seconds_of({15}, 16, costs), 1.0);
  EXPECT_DOUBLE_EQ(cpu_seconds_of({}, 16, costs), 0.0);
}

}  // namespace
}  // namespace lippmann::test

#include "apps/lippmann/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>

namespace lippmann::test {
namespace {

TEST(LineSchedule, first_and_last_are_due_others_more_rarely) {
  app::LineSchedule schedule;
  EXPECT_TRUE(schedule.is_due(1, 1000, 2.0));
  EXPECT_FALSE(schedule.is_due(2, 1000, 31.9)) << "30 s after the previous line";
  EXPECT_TRUE(schedule.is_due(3, 1000, 32.0));
  EXPECT_FALSE(schedule.is_due(4, 1000, 61.0));
  EXPECT_TRUE(schedule.is_due(5, 1000, 3600.0));
  EXPECT_FALSE(schedule.is_due(6, 1000, 3990.0)) << "after an hour, every tenth of the elapsed time";
  EXPECT_TRUE(schedule.is_due(7, 1000, 4000.0));
  EXPECT_TRUE(schedule.is_due(1000, 1000, 4001.0));
}

TEST(LineSchedule, time_left_assumes_a_constant_rate) { EXPECT_DOUBLE_EQ(app::seconds_left(30.0, 3, 12), 90.0); }

TEST(LineSchedule, long_steps_are_due_after_30_s) {
  app::LineSchedule schedule;
  EXPECT_FALSE(schedule.is_due_within(29.9));
  EXPECT_TRUE(schedule.is_due_within(30.0));
  EXPECT_TRUE(schedule.is_due(1, 2, 31.0));
  EXPECT_FALSE(schedule.is_due_within(60.9));
  EXPECT_TRUE(schedule.is_due_within(61.0));
}

/// Returns the lines printed for a frame of 120 s that reports its finished share every 30 s if `knows_share`.
std::string lines_of_a_long_frame(app::ProgressStyle style, bool knows_share) {
  app::Progress::Clock::time_point now{};
  testing::internal::CaptureStderr();
  {
    app::Progress progress(2, style, [&] { return now; });
    progress.set_note("files: about 3 MB");
    for (const double share : {0.25, 0.5, 0.75}) {
      now += std::chrono::seconds(15);
      progress.tick();
      now += std::chrono::seconds(15);
      if (knows_share) progress.within(share);
      progress.tick();
    }
    now += std::chrono::seconds(30);
    progress.step("frame 7: 120 s");
    progress.tick();
  }
  return testing::internal::GetCapturedStderr();
}

// A quarter of the first frame takes 30 s, so two frames take 240 s, of which 210 s (3:30) are left.
TEST(Progress, long_frames_print_lines_without_a_terminal) {
  for (const auto style : {app::ProgressStyle::kLines, app::ProgressStyle::kEveryLine})
    EXPECT_EQ(lines_of_a_long_frame(style, true),
              "[0/2] current frame 25 %; 3:30 left, files: about 3 MB\n"
              "[0/2] current frame 50 %; 3:00 left, files: about 3 MB\n"
              "[0/2] current frame 75 %; 2:30 left, files: about 3 MB\n"
              "[1/2] frame 7: 120 s; 2:00 left, files: about 3 MB\n");
}

TEST(Progress, unknown_shares_print_the_elapsed_time) {
  EXPECT_EQ(lines_of_a_long_frame(app::ProgressStyle::kLines, false),
            "[0/2] 0:30 so far, files: about 3 MB\n"
            "[0/2] 1:00 so far, files: about 3 MB\n"
            "[0/2] 1:30 so far, files: about 3 MB\n"
            "[1/2] frame 7: 120 s; 2:00 left, files: about 3 MB\n");
}

std::string printed_after_first_frame(double frame_s) {
  app::Progress::Clock::time_point now{};
  testing::internal::CaptureStderr();
  app::Progress progress(2, app::ProgressStyle::kLines, [&] { return now; });
  progress.set_advice("Use --frames for less.");
  now += std::chrono::seconds(static_cast<int>(frame_s));
  progress.step("frame 0");
  now += std::chrono::seconds(static_cast<int>(frame_s));
  progress.step("frame 1");
  return testing::internal::GetCapturedStderr();
}

TEST(Progress, long_renders_print_advice_once) {
  EXPECT_EQ(printed_after_first_frame(7200),
            "[1/2] frame 0; 2:00:00 left\nThis will take about 2:00:00 more. Use --frames for less.\n[2/2] frame 1; done\n");
  EXPECT_EQ(printed_after_first_frame(3600), "[1/2] frame 0; 1:00:00 left\n[2/2] frame 1; done\n");
}

TEST(Heartbeat, ends_after_the_current_beat) {
  std::promise<void> begun, may_end;
  std::future<void> end = may_end.get_future();
  bool has_ended = false;
  {
    const app::Heartbeat heartbeat([&] {
      if (has_ended) return;
      begun.set_value();
      end.wait();
      has_ended = true;
    });
    EXPECT_EQ(begun.get_future().wait_for(std::chrono::minutes(1)), std::future_status::ready);
    may_end.set_value();
  }
  EXPECT_TRUE(has_ended);
}

}  // namespace
}  // namespace lippmann::test

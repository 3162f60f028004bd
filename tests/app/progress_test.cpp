// When lines of progress are due, and what they say.
#include "apps/lippmann/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>

namespace lippmann::test {
namespace {

TEST(LineSchedule, first_and_last_are_due_and_others_ever_less_often) {
  app::LineSchedule schedule;
  EXPECT_TRUE(schedule.is_due(1, 1000, 2.0));
  EXPECT_FALSE(schedule.is_due(2, 1000, 31.9)) << "30 s after the line before";
  EXPECT_TRUE(schedule.is_due(3, 1000, 32.0));
  EXPECT_FALSE(schedule.is_due(4, 1000, 61.0));
  EXPECT_TRUE(schedule.is_due(5, 1000, 3600.0));
  EXPECT_FALSE(schedule.is_due(6, 1000, 3990.0)) << "after an hour, every tenth of what has gone";
  EXPECT_TRUE(schedule.is_due(7, 1000, 4000.0));
  EXPECT_TRUE(schedule.is_due(1000, 1000, 4001.0));
}

TEST(LineSchedule, time_left_is_that_of_what_is_done) { EXPECT_DOUBLE_EQ(app::seconds_left(30.0, 3, 12), 90.0); }

TEST(LineSchedule, what_is_under_way_is_due_30_s_after_the_line_before) {
  app::LineSchedule schedule;
  EXPECT_FALSE(schedule.is_due_within(29.9));
  EXPECT_TRUE(schedule.is_due_within(30.0));
  EXPECT_TRUE(schedule.is_due(1, 2, 31.0));
  EXPECT_FALSE(schedule.is_due_within(60.9));
  EXPECT_TRUE(schedule.is_due_within(61.0));
}

/// What is printed of a frame of four parts of 30 s each, the share of which is known or not.
std::string said_of_a_long_frame(app::ProgressStyle style, bool knows_share) {
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

// Two frames take 240 s: after 30 s, 210 s are left.
TEST(Progress, without_a_terminal_a_long_frame_gets_lines_while_it_is_traced) {
  for (const auto style : {app::ProgressStyle::kLines, app::ProgressStyle::kEveryLine})
    EXPECT_EQ(said_of_a_long_frame(style, true),
              "[0/2] current frame 25 %; 3:30 left, files: about 3 MB\n"
              "[0/2] current frame 50 %; 3:00 left, files: about 3 MB\n"
              "[0/2] current frame 75 %; 2:30 left, files: about 3 MB\n"
              "[1/2] frame 7: 120 s; 2:00 left, files: about 3 MB\n");
}

TEST(Progress, of_a_frame_whose_share_nobody_knows_is_the_time_so_far) {
  EXPECT_EQ(said_of_a_long_frame(app::ProgressStyle::kLines, false),
            "[0/2] 0:30 so far, files: about 3 MB\n"
            "[0/2] 1:00 so far, files: about 3 MB\n"
            "[0/2] 1:30 so far, files: about 3 MB\n"
            "[1/2] frame 7: 120 s; 2:00 left, files: about 3 MB\n");
}

/// What is printed after the first of two frames, which took `frame_s` seconds.
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

TEST(Progress, more_than_an_hour_left_prints_estimate_and_advice_once) {
  EXPECT_EQ(printed_after_first_frame(7200),
            "[1/2] frame 0; 2:00:00 left\nThis will take about 2:00:00 more. Use --frames for less.\n[2/2] frame 1; done\n");
  EXPECT_EQ(printed_after_first_frame(3600), "[1/2] frame 0; 1:00:00 left\n[2/2] frame 1; done\n");
}

TEST(Heartbeat, ends_with_the_beat_under_way) {
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

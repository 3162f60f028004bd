#include <gtest/gtest.h>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

RenderParams floored(RenderParams scene, double db, std::optional<int> keyframes = {}) {
  return with_reuse(scene, {.choice = ReuseChoice::kInterpolate, .keyframes = keyframes, .min_psnr_db = db});
}

struct PredictedFrames {
  int all = 0, kept = 0;
};

void count_predicted(const MadeFrames& traced, const MadeFrames& made, double floor, PredictedFrames& count) {
  for (const auto& [number, frame] : made.frames) {
    const FrameReport& report = frame.report;
    if (report.kind != "in-between") {
      EXPECT_EQ(made.film(number), traced.film(number)) << number;
      EXPECT_FALSE(report.estimated_psnr_db.has_value());
      continue;
    }
    ++count.all;
    count.kept += psnr_between(traced, made, number) >= floor;
    EXPECT_GE(report.psnr_at_least_db.value(), floor);
    EXPECT_GE(report.estimated_psnr_db.value(), report.psnr_at_least_db.value());
  }
}

TEST(FloorFrames, reach_the_goal_in_95_percent_of_frames) {
  PredictedFrames count;
  for (const char* name : {"teapot", "room", "small-balls", "primitives", "tree", "gears"}) {
    RenderParams scene = small_scene(name);
    scene.optics.lenses = {32, 0};
    const MadeFrames traced = make_frames(scene, frames_from(40, 48));
    for (const double floor : {32.0, 38.0}) {
      SCOPED_TRACE(testing::Message() << name << " at " << floor << " dB");
      count_predicted(traced, make_frames(floored(scene, floor), frames_from(40, 48)), floor, count);
    }
  }
  EXPECT_GT(count.all, 50);
  EXPECT_GE(100 * count.kept, 95 * count.all) << count.kept << " of " << count.all;
  RecordProperty("predicted", count.all);
  RecordProperty("kept", count.kept);
}

TEST(FloorFrames, any_thread_count_gives_the_same_bits) {
  const RenderParams gears = floored(small_scene("gears"), 45.0);
  const auto one = make_frames(gears, frames_from(0, 8), 1).films();
  EXPECT_EQ(make_frames(gears, frames_from(0, 8), 2).films(), one);
  EXPECT_EQ(make_frames(gears, frames_from(0, 8), 4).films(), one);
}

TEST(FloorFrames, of_a_part_equal_the_whole) {
  for (const double floor : {35.0, 50.0}) {  // at 35 dB, few intervals between key frames are halved; at 50 dB, many are
    const RenderParams gears = floored(small_scene("gears"), floor);
    const MadeFrames whole = make_frames(gears, frames_from(0, 9));
    for (const std::vector<int>& part : {std::vector{1, 2}, std::vector{5, 6}, std::vector{7}, std::vector{3, 4, 9}})
      for (const auto& [number, film] : make_frames(gears, part).films())
        EXPECT_EQ(film, whole.film(number)) << number << " of " << part.front();
  }
}

TEST(FloorFrames, are_traced_once_if_prediction_never_pays) {
  const MadeFrames made = make_frames(floored(small_scene("gears"), 70.0), frames_from(0, 20));
  std::uint64_t rays = 0;
  for (const auto& [number, frame] : made.frames) {
    EXPECT_NE(frame.report.kind, "in-between");
    rays += frame.report.rays.primary;
  }
  EXPECT_EQ(rays, 21u * 128 * 128);
  EXPECT_TRUE(made.sources.empty());
  EXPECT_EQ(made.films(), make_frames(small_scene("gears"), frames_from(0, 20)).films());
}

// Frame 1 is traced, so that the error of interpolation can be measured.
TEST(FloorFrames, keep_requested_keys) {
  const MadeFrames made = make_frames(floored(small_scene(), 30.0, 2), frames_from(0, 4));
  for (const int key : {0, 2, 4}) EXPECT_EQ(made.report(key).kind, "key") << key;
  EXPECT_EQ(made.report(1).kind, "full");
  const FrameReport& predicted = made.report(3);
  EXPECT_EQ(predicted.kind, "in-between");
  EXPECT_EQ(predicted.retraced_pixels, predicted.rays.primary);
  EXPECT_EQ(predicted.retraced_pixels + predicted.reused_pixels, 128u * 128);
}

TEST(FloorFrames, reach_the_goal_for_all_optics) {
  const std::vector<OpticsParams> kinds{{.kind = OpticsKind::kMicrolens, .lenses = {12, 0}},
                                        {.kind = OpticsKind::kMultiview, .size = {128, 128}, .views = {4, 2}},
                                        {.kind = OpticsKind::kSingle, .size = {96, 64}},
                                        {.lenses = {12, 0}, .lens_pixels = {7.5f, 0}, .slant_deg = 9.0f}};
  for (const OpticsParams& optics : kinds) {
    RenderParams scene = small_scene();
    scene.optics = optics;
    const MadeFrames traced = make_frames(scene, {1}), made = make_frames(floored(scene, 35.0, 2), frames_from(0, 2));
    EXPECT_GE(psnr_between(traced, made, 1), 35.0) << made.pixels;
  }
}

}  // namespace
}  // namespace lippmann::test

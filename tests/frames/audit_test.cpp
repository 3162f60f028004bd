// The error that path-traced frames report of themselves.
#include "frames/audit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

// Mean 2, standard error sqrt(((1 - 2)^2 + (3 - 2)^2) / 1 / 2) = 1: half a width of 2 standard errors is the mean itself.
TEST(ErrorInterval, lies_symmetrically_about_the_logarithm_of_the_mean) {
  const ErrorInterval interval = error_interval(std::array{1.0, 3.0});
  EXPECT_DOUBLE_EQ(interval.mean, 2.0);
  EXPECT_DOUBLE_EQ(interval.low, 2.0 / std::exp(1.0));
  EXPECT_DOUBLE_EQ(interval.high, 2.0 * std::exp(1.0));
}

TEST(ErrorInterval, of_a_mean_that_is_not_positive_begins_at_0) {
  const ErrorInterval interval = error_interval(std::array{-1.0, 1.0});
  EXPECT_EQ(interval.mean, 0.0);
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_DOUBLE_EQ(interval.high, 2.0);
}

/// As traced: the error of 2 samples is far above the noise of the held-out pixels, so that an estimate exists.
RenderParams noisy_paths() {
  RenderParams params = small_scene();
  params.optics.lenses = {8, 0};
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = 2, params.sampling.denoise = Denoise::kNone;
  return params;
}

TEST(Audit, changes_no_picture) {
  const RenderParams params = with_scene_defaults(noisy_paths());
  const Context context;
  const ThreadPool pool(1);
  JobStage stage(params, pool, context);
  EXPECT_EQ(make_frames(params, {3}).film(3), render_frame(stage, params.sampling, 3, pool, context).pictures.film.data);
}

TEST(Audit, is_the_same_on_any_number_of_threads_and_in_any_part) {
  const FrameReport one = make_frames(noisy_paths(), {3}, 1).report(3), more = make_frames(noisy_paths(), {2, 3}, 3).report(3);
  ASSERT_TRUE(one.estimated_psnr_db && one.psnr_at_least_db && one.psnr_at_most_db);
  EXPECT_EQ(one.estimated_psnr_db, more.estimated_psnr_db);
  EXPECT_EQ(one.psnr_at_least_db, more.psnr_at_least_db);
  EXPECT_EQ(one.psnr_at_most_db, more.psnr_at_most_db);
  EXPECT_LT(one.psnr_at_least_db, one.estimated_psnr_db);
  EXPECT_LT(one.estimated_psnr_db, one.psnr_at_most_db);
}

// 20 seeds against one reference of 128 times their samples. If each interval holds with probability 0.9, fewer than 12 of 20
// hold with probability 7e-5.
TEST(Audit, intervals_mostly_contain_the_truth) {
  constexpr int kSeeds = 20, kLeastHeld = 12;
  RenderParams params = noisy_paths();
  params.sampling.spp = 256, params.sampling.seed = kSeeds;
  const MadeFrames reference = make_frames(params, {3});
  params.sampling.spp = 2;
  int held = 0;
  for (params.sampling.seed = 0; params.sampling.seed < kSeeds; ++params.sampling.seed) {
    const MadeFrames made = make_frames(params, {3});
    const FrameReport& report = made.report(3);
    const double true_db = psnr_between(reference, made, 3);
    held += *report.psnr_at_least_db <= true_db && true_db <= *report.psnr_at_most_db;
  }
  EXPECT_GE(held, kLeastHeld);
}

TEST(Audit, of_denoised_frames_has_a_lower_bound) {
  RenderParams params = noisy_paths();
  params.sampling.denoise = Denoise::kAuto;
  EXPECT_GT(make_frames(params, {3}).report(3).psnr_at_least_db.value(), 0.0);
}

TEST(Audit, of_whitted_shading_and_of_motion_blur_is_left_out) {
  RenderParams whitted = small_scene(), blurred = noisy_paths();
  blurred.sampling.shutter = 0.5f;
  for (const RenderParams& params : {whitted, blurred}) {
    const FrameReport report = make_frames(params, {3}).report(3);
    EXPECT_FALSE(report.estimated_psnr_db || report.psnr_at_least_db || report.psnr_at_most_db);
  }
}

}  // namespace
}  // namespace lippmann::test

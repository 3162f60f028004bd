#include "frames/audit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

// Mean: (1 + 3) / 2 = 2. Standard error: sqrt(((1 - 2)^2 + (3 - 2)^2) / 1 / 2) = 1. The interval is the mean times
// exp(+-2 * standard error / mean).
TEST(ErrorInterval, is_symmetric_in_the_logarithm) {
  const ErrorInterval interval = error_interval(std::array{1.0, 3.0});
  EXPECT_DOUBLE_EQ(interval.mean, 2.0);
  EXPECT_DOUBLE_EQ(interval.low, 2.0 / std::exp(1.0));
  EXPECT_DOUBLE_EQ(interval.high, 2.0 * std::exp(1.0));
}

TEST(ErrorInterval, starts_at_0_without_a_positive_mean) {
  const ErrorInterval interval = error_interval(std::array{-1.0, 1.0});
  EXPECT_EQ(interval.mean, 0.0);
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_DOUBLE_EQ(interval.high, 2.0);
}

/// With 2 samples per pixel and no denoising, the error is far above the noise of its estimate.
RenderParams noisy_paths() {
  RenderParams params = small_scene();
  params.optics.lenses = {8, 0};
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = 2, params.sampling.denoise = Denoise::kNone;
  return params;
}

TEST(Audit, does_not_change_the_picture) {
  const ResolvedJob job(noisy_paths());
  const Context context;
  const ThreadPool pool(1);
  JobStage stage(job, pool, context);
  EXPECT_EQ(make_frames(noisy_paths(), {3}).film(3), render_frame(stage, job.sampling(), 3, pool, context).pictures.film.data);
}

TEST(Audit, does_not_depend_on_threads_or_range) {
  const FrameReport one = make_frames(noisy_paths(), {3}, 1).report(3), more = make_frames(noisy_paths(), {2, 3}, 3).report(3);
  ASSERT_TRUE(one.estimated_psnr_db && one.psnr_at_least_db && one.psnr_at_most_db);
  EXPECT_EQ(one.estimated_psnr_db, more.estimated_psnr_db);
  EXPECT_EQ(one.psnr_at_least_db, more.psnr_at_least_db);
  EXPECT_EQ(one.psnr_at_most_db, more.psnr_at_most_db);
  EXPECT_LT(one.psnr_at_least_db, one.estimated_psnr_db);
  EXPECT_LT(one.estimated_psnr_db, one.psnr_at_most_db);
}

// References have 128 times as many samples. If each interval contains the truth with probability 0.9, the probability
// that fewer than 12 of 20 intervals contain it is 7e-5.
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

TEST(Audit, gives_denoised_frames_a_lower_bound) {
  RenderParams params = noisy_paths();
  params.sampling.denoise = Denoise::kAuto;
  EXPECT_GT(make_frames(params, {3}).report(3).psnr_at_least_db.value(), 0.0);
}

TEST(Audit, skips_whitted_shading_and_motion_blur) {
  RenderParams whitted = small_scene(), blurred = noisy_paths();
  blurred.sampling.shutter = 0.5f;
  for (const RenderParams& params : {whitted, blurred}) {
    const FrameReport report = make_frames(params, {3}).report(3);
    EXPECT_FALSE(report.estimated_psnr_db || report.psnr_at_least_db || report.psnr_at_most_db);
  }
}

}  // namespace
}  // namespace lippmann::test

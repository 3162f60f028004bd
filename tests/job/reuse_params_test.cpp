#include "job/reuse_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job/reuse_sentence.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

RenderParams params_with(ReuseChoice choice, Integrator integrator = Integrator::kWhitted) {
  RenderParams params;
  params.sampling.integrator = integrator;
  params.sampling.spp = integrator == Integrator::kPath ? 32 : 1;
  params.reuse.choice = choice;
  return params;
}

std::string refused(const RenderParams& params) {
  try {
    frame_params(ResolvedJob(params));
  } catch (const Error& error) {
    return error.where();
  }
  return {};
}

RenderParams with_reuse(const ReuseParams& reuse) {
  RenderParams params = params_with(ReuseChoice::kAuto);
  params.reuse = reuse;
  return params;
}

TEST(ReuseParams, auto_ignores_key_frames_for_paths) {
  RenderParams paths = params_with(ReuseChoice::kAuto, Integrator::kPath);
  paths.reuse.keyframes = 5;
  EXPECT_STREQ(name_of(frame_params(ResolvedJob(paths)).reuse), "none");
  RenderParams whitted = params_with(ReuseChoice::kAuto);
  whitted.reuse.keyframes = 5;
  EXPECT_EQ(std::get<CopySettled>(frame_params(ResolvedJob(whitted)).reuse).keyframes, 5);
}

TEST(ReuseParams, missed_pixels_may_stay_black) {
  RenderParams params = params_with(ReuseChoice::kInterpolate);
  params.reuse.debug = DebugPicture::kMissed;
  EXPECT_EQ(std::get<Interpolate>(frame_params(ResolvedJob(params)).reuse).fill, MissedFill::kBlack);
  params.reuse.fill = MissedFill::kRetrace;
  EXPECT_EQ(refused(params), "--fill");
  params.reuse.fill = MissedFill::kInterpolate;
  params.reuse.min_psnr_db = 50.0;
  EXPECT_EQ(refused(params), "--debug");
}

TEST(ReuseParams, parameters_without_effect_are_refused) {
  const auto with = [](RenderParams params, auto set) {
    set(params.reuse);
    return refused(params);
  };
  const auto keyframes = [](ReuseParams& reuse) { reuse.keyframes = 4; };
  const auto splat = [](ReuseParams& reuse) { reuse.splat = SplatMode::kLens; };
  const auto floor = [](ReuseParams& reuse) { reuse.min_psnr_db = 40.0; };
  EXPECT_EQ(with(params_with(ReuseChoice::kNone), keyframes), "--keyframes");
  EXPECT_EQ(with(params_with(ReuseChoice::kNone), floor), "--min-psnr");
  EXPECT_EQ(with(params_with(ReuseChoice::kCopy), splat), "--splat");
  EXPECT_EQ(with(params_with(ReuseChoice::kAuto, Integrator::kPath), floor), "--min-psnr");
  EXPECT_EQ(with(params_with(ReuseChoice::kAuto, Integrator::kPath), splat), "--splat");
}

TEST(ReuseParams, interpolation_parameters_are_refused_for_copies) {
  EXPECT_EQ(refused(with_reuse({.splat = SplatMode::kLens})), "--splat");
  EXPECT_EQ(refused(with_reuse({.fill = MissedFill::kRetrace})), "--fill");
  EXPECT_EQ(refused(with_reuse({.halving = true})), "--halving");
  EXPECT_EQ(refused(with_reuse({.no_z_buffer = true})), "--no-z-buffer");
  EXPECT_EQ(refused(with_reuse({.debug = DebugPicture::kMissed})), "--debug");
}

TEST(ReuseParams, copied_pixels_satisfy_any_minimum_psnr) {
  RenderParams params = params_with(ReuseChoice::kAuto);
  params.reuse.min_psnr_db = 50.0;
  EXPECT_STREQ(name_of(frame_params(ResolvedJob(params)).reuse), "copy");
}

TEST(ReuseSentence, begins_with_the_kind_in_effect) {
  RenderReport report;
  report.optics.panel = {10, 10, 1.0f};
  report.frames.resize(2);
  report.frames[1].reused_pixels = 50;
  report.reuse = CopySettled{};
  EXPECT_EQ(reuse_sentence(report), "copy: 25.0 % of all pixels are unchanged and were copied from key frames");
  report.reuse = TraceAll{};
  EXPECT_EQ(reuse_sentence(report), "none: every frame was traced in full");
  report.frames[1].kind = "in-between";
  report.frames[1].missed_pixels = 10;
  report.reuse = Interpolate{};
  EXPECT_THAT(reuse_sentence(report),
              StartsWith("interpolate: 1 frame interpolated between 0 traced frames; 10.00 % of the pixels missed"));
}

FrameReport estimated(int number, double psnr_db, std::optional<double> at_least_db, std::optional<double> at_most_db) {
  FrameReport frame;
  frame.frame = number;
  frame.estimated_psnr_db = psnr_db, frame.psnr_at_least_db = at_least_db, frame.psnr_at_most_db = at_most_db;
  return frame;
}

TEST(ErrorSentence, one_frame_has_estimate_and_interval) {
  EXPECT_EQ(error_sentence({estimated(3, 41.8, 40.2, 43.7)}), "estimated error 42 dB (40 to 44)");
  EXPECT_EQ(error_sentence({estimated(3, 41.8, 40.2, {})}), "estimated error 42 dB (at least 40)");
}

TEST(ErrorSentence, several_frames_give_the_worst) {
  const std::vector<FrameReport> frames{estimated(6, 41.0, 40.0, 42.0), estimated(7, 38.0, 37.0, 39.0), FrameReport{}};
  EXPECT_EQ(error_sentence(frames), "estimated error at worst 38 dB (37 to 39), in frame 7");
}

TEST(ErrorSentence, frame_without_visible_error_has_bound) {
  FrameReport frame;
  frame.psnr_at_least_db = 54.4;
  EXPECT_EQ(error_sentence({frame}), "estimated error 54 dB or better");
}

TEST(ErrorSentence, frames_without_estimate_give_nothing) { EXPECT_EQ(error_sentence({FrameReport{}}), ""); }

}  // namespace
}  // namespace lippmann

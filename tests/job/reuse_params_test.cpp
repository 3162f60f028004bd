// From what is said of reuse to the kind that serves, and the sentence that tells of it afterwards.
#include "job/reuse_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job/reuse_sentence.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

RenderParams said(ReuseChoice choice, Integrator integrator = Integrator::kWhitted) {
  RenderParams params;
  params.sampling.integrator = integrator;
  params.sampling.spp = integrator == Integrator::kPath ? 32 : 1;
  params.reuse.choice = choice;
  return params;
}

std::string refused(const RenderParams& params) {
  try {
    frame_params(params);
  } catch (const Error& error) {
    return error.where();
  }
  return {};
}

RenderParams with_reuse(const ReuseParams& reuse) {
  RenderParams params = said(ReuseChoice::kAuto);
  params.reuse = reuse;
  return params;
}

TEST(ReuseParams, auto_takes_goals_and_key_frames_to_the_kind_that_serves) {
  RenderParams paths = said(ReuseChoice::kAuto, Integrator::kPath);
  paths.reuse.min_psnr_db = 42.0;
  EXPECT_EQ(std::get<ShareLight>(frame_params(paths).reuse).min_psnr_db, 42.0);
  paths.reuse.keyframes = 5;  // as jobs for many scenes say it: frames that share light have none
  EXPECT_STREQ(name_of(frame_params(paths).reuse), "light");
  RenderParams whitted = said(ReuseChoice::kAuto);
  whitted.reuse.keyframes = 5;
  EXPECT_EQ(std::get<CopySettled>(frame_params(whitted).reuse).keyframes, 5);
}

TEST(ReuseParams, missed_pixels_stay_black_to_be_looked_at) {
  RenderParams params = said(ReuseChoice::kInterpolate);
  params.reuse.debug = DebugPicture::kMissed;
  EXPECT_EQ(std::get<Interpolate>(frame_params(params).reuse).fill, MissedFill::kBlack);
  params.reuse.fill = MissedFill::kRetrace;
  EXPECT_EQ(refused(params), "--fill");
  params.reuse.fill = MissedFill::kInterpolate;
  params.reuse.min_psnr_db = 50.0;
  EXPECT_EQ(refused(params), "--debug");
}

TEST(ReuseParams, what_the_kind_that_serves_does_not_know_is_refused) {
  const auto with = [](RenderParams params, auto set) {
    set(params.reuse);
    return refused(params);
  };
  const auto keyframes = [](ReuseParams& reuse) { reuse.keyframes = 4; };
  const auto splat = [](ReuseParams& reuse) { reuse.splat = SplatMode::kLens; };
  const auto budget = [](ReuseParams& reuse) { reuse.time_budget_s = 1.0; };
  const auto floor = [](ReuseParams& reuse) { reuse.min_psnr_db = 40.0; };
  const auto provenance = [](ReuseParams& reuse) { reuse.debug = DebugPicture::kProvenance; };
  EXPECT_EQ(with(said(ReuseChoice::kNone), keyframes), "--keyframes");
  EXPECT_EQ(with(said(ReuseChoice::kNone), floor), "--min-psnr");
  EXPECT_EQ(with(said(ReuseChoice::kCopy), splat), "--splat");
  EXPECT_EQ(with(said(ReuseChoice::kCopy), budget), "--time-budget");
  EXPECT_EQ(with(said(ReuseChoice::kInterpolate), budget), "--time-budget");
  EXPECT_EQ(with(said(ReuseChoice::kInterpolate), provenance), "--debug");
  EXPECT_EQ(with(said(ReuseChoice::kLight, Integrator::kPath), keyframes), "--keyframes");
  EXPECT_EQ(with(said(ReuseChoice::kLight, Integrator::kPath), splat), "--splat");
  EXPECT_EQ(with(said(ReuseChoice::kNone, Integrator::kPath), budget), "--time-budget");
}

TEST(ReuseParams, quality_at_the_eye_is_for_shared_light_and_no_budget_of_time) {
  RenderParams paths = said(ReuseChoice::kAuto, Integrator::kPath);
  paths.reuse.quality_at = QualityAt::kEye;
  EXPECT_EQ(std::get<ShareLight>(frame_params(paths).reuse).quality_at, QualityAt::kEye);
  paths.reuse.time_budget_s = 1.0;
  EXPECT_EQ(refused(paths), "quality-at");
  RenderParams none = said(ReuseChoice::kNone, Integrator::kPath), whitted = said(ReuseChoice::kAuto);
  for (RenderParams* params : {&none, &whitted}) {
    params->reuse.quality_at = QualityAt::kEye;
    EXPECT_EQ(refused(*params), "--quality-at");
  }
}

TEST(ReuseParams, what_looks_at_shared_light_is_refused_where_none_is_shared) {
  RenderParams few = said(ReuseChoice::kAuto, Integrator::kPath), many = few, whitted = said(ReuseChoice::kAuto);
  few.sampling.spp = 2;
  for (RenderParams* params : {&few, &many, &whitted}) params->reuse.debug = DebugPicture::kProvenance;
  EXPECT_EQ(refused(few), "--debug");
  EXPECT_EQ(refused(whitted), "--debug");
  EXPECT_TRUE(std::get<ShareLight>(frame_params(many).reuse).show_provenance);
}

TEST(ReuseParams, what_interpolates_is_refused_where_pixels_are_copied) {
  EXPECT_EQ(refused(with_reuse({.splat = SplatMode::kLens})), "--splat");
  EXPECT_EQ(refused(with_reuse({.fill = MissedFill::kRetrace})), "--fill");
  EXPECT_EQ(refused(with_reuse({.halving = true})), "--halving");
  EXPECT_EQ(refused(with_reuse({.no_z_buffer = true})), "--no-z-buffer");
  EXPECT_EQ(refused(with_reuse({.debug = DebugPicture::kMissed})), "--debug");
}

TEST(ReuseParams, copied_pixels_keep_to_any_floor) {
  RenderParams params = said(ReuseChoice::kAuto);
  params.reuse.min_psnr_db = 50.0;
  EXPECT_STREQ(name_of(frame_params(params).reuse), "copy");
}

TEST(ReuseParams, layers_of_whole_paths_keep_light_from_being_shared_and_that_is_said) {
  RenderParams params = said(ReuseChoice::kAuto, Integrator::kPath);
  EXPECT_EQ(whole_paths_sentence(params), "");
  params.sampling.aov = {Aov::kDirect};
  EXPECT_STREQ(name_of(frame_params(params).reuse), "none");
  EXPECT_THAT(whole_paths_sentence(params), HasSubstr("no light is shared"));
  params.reuse.choice = ReuseChoice::kNone;
  EXPECT_EQ(whole_paths_sentence(params), "") << "nobody wants to share any";
}

TEST(ReuseParams, motion_blur_has_every_frame_traced_and_that_is_said) {
  RenderParams params = said(ReuseChoice::kAuto, Integrator::kPath);
  params.sampling.shutter = 0.5f;
  EXPECT_STREQ(name_of(frame_params(params).reuse), "none");
  EXPECT_THAT(whole_paths_sentence(params), HasSubstr("--shutter"));
}

TEST(ReuseParams, other_layers_alpha_and_denoising_leave_light_shared) {
  for (const Sampling& more : {Sampling{.aov = {Aov::kDepth}}, Sampling{.transparent = true}, Sampling{.denoise = true}}) {
    RenderParams params = said(ReuseChoice::kAuto, Integrator::kPath);
    params.sampling.aov = more.aov, params.sampling.transparent = more.transparent, params.sampling.denoise = more.denoise;
    EXPECT_EQ(whole_paths_sentence(params), "");
    EXPECT_STREQ(name_of(frame_params(params).reuse), "light");
  }
}

TEST(ReuseSentence, begins_with_the_kind_that_served_and_tells_what_it_did) {
  RenderReport report;
  report.optics.panel = {10, 10, 1.0f};
  report.frames.resize(2);
  report.frames[1].reused_pixels = 50;
  report.reuse = CopySettled{};
  EXPECT_EQ(reuse_sentence(report), "copy: 25.0 % of all pixels are unchanged and were copied from key frames");
  report.reuse = TraceAll{};
  EXPECT_EQ(reuse_sentence(report), "none: every frame was traced in full");
  report.reuse = ShareLight{};
  EXPECT_THAT(reuse_sentence(report), StartsWith("light: every frame was traced in full"));
  report.frames[1].kind = "in-between";
  report.frames[1].missed_pixels = 10;
  report.reuse = Interpolate{};
  EXPECT_THAT(reuse_sentence(report),
              StartsWith("interpolate: 1 frame interpolated between 0 traced frames; 10.00 % of the pixels missed"));
}

}  // namespace
}  // namespace lippmann

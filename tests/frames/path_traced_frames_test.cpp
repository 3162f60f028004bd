// Path-traced frames, whole and of shared light: that neither threads nor parts nor layers change them, and what they tell of
// their errors.
#include <gtest/gtest.h>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

RenderParams paths(int lenses, int spp, const char* name = "teapot") {
  RenderParams params = small_scene(name);
  params.optics.lenses = {lenses, 0};
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = spp;
  return params;
}

/// Enough samples for soft light to be shared, which in so small a picture pays in a room, with each of four seeds.
RenderParams shared_light(const ReuseParams& goal = {}) {
  RenderParams params = paths(16, 64, "room");
  params.optics.fit_depth = false;
  return with_reuse(params, goal);
}

RenderParams shared_light_with(const Sampling& more) {
  RenderParams params = shared_light();
  params.sampling.aov = more.aov;
  params.sampling.denoise = more.denoise;
  params.sampling.transparent = more.transparent;
  return params;
}

/// Frames of `part` are those of `whole`: light, alpha and layers.
void expect_the_same(const MadeFrames& part, const MadeFrames& whole) {
  for (const auto& [number, frame] : part.frames) {
    EXPECT_EQ(frame.pictures.film.data, whole.film(number)) << number;
    EXPECT_EQ(frame.pictures.aovs[Aov::kAlpha].data, whole.frames.at(number).pictures.aovs[Aov::kAlpha].data) << number;
  }
}

TEST(PathTracedFrames, are_the_same_on_any_number_of_threads_and_alone) {
  const MadeFrames one = make_frames(paths(8, 2), {0, 1}, 1);
  EXPECT_NE(one.film(0), one.film(1));
  expect_the_same(make_frames(paths(8, 2), {0, 1}, 3), one);
  expect_the_same(make_frames(paths(8, 2), {1}), one);
}

TEST(PathTracedFrames, count_their_rays) {
  const RayCounts rays = make_frames(paths(8, 2), {0}).report(0).rays;
  EXPECT_EQ(rays.primary, 2u * 64 * 64);
  EXPECT_GT(rays.indirect, 0u);
  EXPECT_GT(rays.shadow, 0u);
}

TEST(SharedLightFrames, are_the_same_with_layers_which_are_those_of_traced_frames) {
  const std::vector<Aov> layers{Aov::kDepth, Aov::kMotion};
  RenderParams all_paths = shared_light_with({.aov = layers});
  all_paths.reuse.choice = ReuseChoice::kNone;
  const MadeFrames alone = make_frames(shared_light(), {1}), layered = make_frames(shared_light_with({.aov = layers}), {1}),
                   traced = make_frames(all_paths, {1});
  EXPECT_EQ(layered.film(1), alone.film(1));
  EXPECT_NE(layered.film(1), traced.film(1));
  for (const Aov layer : layers) {
    const auto of = [&](const MadeFrames& made) { return made.frames.at(1).pictures.aovs[layer].data; };
    EXPECT_FALSE(of(layered).empty());
    EXPECT_EQ(of(layered), of(traced));
  }
}

TEST(SharedLightFrames, before_nothing_are_the_same_whole_and_in_parts) {
  const RenderParams params = shared_light_with({.transparent = true});
  const MadeFrames whole = make_frames(params, frames_from(0, 2)), part = make_frames(params, {2});
  expect_the_same(part, whole);
  EXPECT_FALSE(part.frames.at(2).pictures.aovs[Aov::kAlpha].data.empty());
}

// Frames 14 to 17 belong to two histories, of which frame 15 ends one. Frames without noise are made of neighbours in the same
// history alone, whether or not others follow, and of all that the shared light of these is.
TEST(SharedLightFrames, are_the_same_whole_and_in_parts_on_any_number_of_threads_and_denoised) {
  const RenderParams params = shared_light_with({.denoise = true, .transparent = true});
  for (const auto& [number, frame] : make_frames(params, {0, 1}).frames) EXPECT_EQ(frame.report.kind, "shared");
  const MadeFrames whole = make_frames(params, frames_from(14, 17));
  for (const int number : {15, 16, 17}) expect_the_same(make_frames(params, {number}, 3), whole);
  EXPECT_NE(make_frames(shared_light_with({.transparent = true}), {16}).film(16), whole.film(16));
}

// With four seeds 19 to 38 % of the rays of paths. A picture half as wide takes 27 to 144 %, by luck: too few patches tell how
// wrong its light is.
TEST(SharedLightFrames, save_rays_in_a_room) {
  RenderParams params = shared_light();
  params.optics.lenses = {32, 0};
  const FrameReport shared = make_frames(params, {0, 1}).report(1),
                    traced = make_frames(with_reuse(params, {.choice = ReuseChoice::kNone}), {1}).report(1);
  EXPECT_LT(shared.rays.total(), traced.rays.total() / 2);
  EXPECT_GT(shared.estimated_psnr_db.value(), 25.0);
  EXPECT_FALSE(traced.estimated_psnr_db.has_value());
}

void expect_errors(const FrameReport& report, const std::string& kind) {
  EXPECT_EQ(report.kind, kind);
  EXPECT_LT(report.psnr_at_least_db.value(), report.estimated_psnr_db.value());
  // Noise of pixels averages out in means over 64.
  EXPECT_GT(report.estimated_block_psnr_db.value(), report.estimated_psnr_db.value());
}

TEST(SharedLightFrames, tell_their_errors_and_others_tell_none) {
  for (const ReuseParams& goal : {ReuseParams{}, ReuseParams{.min_psnr_db = 30.0}, ReuseParams{.time_budget_s = 0.01}})
    for (const auto& [number, frame] : make_frames(shared_light(goal), frames_from(0, 2)).frames)
      expect_errors(frame.report, "shared");
  const MadeFrames traced = make_frames(with_reuse(shared_light(), {.choice = ReuseChoice::kNone}), {0, 1});
  for (const auto& [number, frame] : traced.frames) {
    EXPECT_EQ(frame.report.kind, "full");
    EXPECT_FALSE(frame.report.estimated_psnr_db || frame.report.psnr_at_least_db || frame.report.estimated_block_psnr_db);
  }
}

// 70 dB are an error of 0.08 codes, which is less than cells are known to, and than 64 times as many paths reach.
TEST(SharedLightFrames, that_are_traced_whole_for_a_floor_are_measured_too) {
  for (const auto& [number, frame] : make_frames(with_reuse(paths(4, 8), {.min_psnr_db = 70.0}), {0, 1}).frames) {
    expect_errors(frame.report, "full");
    EXPECT_LT(frame.report.estimated_psnr_db.value(), 70.0);
  }
}

TEST(SharedLightFrames, within_a_budget_of_time_are_like_the_wanted_ones) {
  const MadeFrames made = make_frames(shared_light({.time_budget_s = 0.01}), {0, 1});
  EXPECT_GT(made.report(1).estimated_psnr_db.value(), 20.0);
}

TEST(SharedLightFrames, take_more_rays_the_higher_their_floor_is) {
  const auto primary = [](double db) { return make_frames(shared_light({.min_psnr_db = db}), {1}).report(1).rays.primary; };
  EXPECT_LT(primary(30.0), primary(40.0));
}

}  // namespace
}  // namespace lippmann::test

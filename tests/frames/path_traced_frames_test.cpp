#include <gtest/gtest.h>

#include <cmath>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

RenderParams paths(int spp, Denoise denoise = Denoise::kAuto, const char* name = "teapot") {
  RenderParams params = small_scene(name);
  params.optics.lenses = {8, 0};
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = spp, params.sampling.denoise = denoise;
  return params;
}

void expect_the_same(const MadeFrames& part, const MadeFrames& whole) {
  for (const auto& [number, frame] : part.frames) {
    EXPECT_EQ(frame.pictures.film.data, whole.film(number)) << number;
    EXPECT_EQ(frame.pictures.aovs[Aov::kAlpha].data, whole.frames.at(number).pictures.aovs[Aov::kAlpha].data) << number;
  }
}

double squared_error(const std::vector<float>& reference, const std::vector<float>& film) {
  double sum = 0.0;
  for (std::size_t i = 0; i < film.size(); ++i) sum += std::pow(std::min(film[i], 1.0f) - std::min(reference[i], 1.0f), 2.0);
  return sum / static_cast<double>(film.size());
}

MadeFrames reference_of(RenderParams params, int frame) {
  params.sampling.spp = 512, params.sampling.seed = 1, params.sampling.denoise = Denoise::kNone;
  return make_frames(params, {frame});
}

/// Expects that denoising halves the squared error. The limit leaves a margin for the noise of the reference and of the
/// measured errors.
void expect_less_noise(const RenderParams& params, int frame) {
  RenderParams noisy = params;
  noisy.sampling.denoise = Denoise::kNone;
  const std::vector<float> reference = reference_of(params, frame).film(frame);
  EXPECT_LT(squared_error(reference, make_frames(params, {frame}).film(frame)),
            0.5 * squared_error(reference, make_frames(noisy, {frame}).film(frame)));
}

class PathTracedFrames : public testing::TestWithParam<Denoise> {};

TEST_P(PathTracedFrames, do_not_depend_on_threads_or_range) {
  RenderParams params = paths(2, GetParam());
  params.sampling.transparent = true;
  const MadeFrames one = make_frames(params, {0, 1, 2}, 1);
  EXPECT_NE(one.film(0), one.film(1));
  expect_the_same(make_frames(params, {0, 1, 2}, 3), one);
  for (const int frame : {1, 2}) expect_the_same(make_frames(params, {frame}), one);
  EXPECT_TRUE(one.sources.empty());
}

TEST_P(PathTracedFrames, are_the_same_with_layers) {
  RenderParams layered = paths(2, GetParam());
  layered.sampling.aov = {Aov::kDepth, Aov::kMotion, Aov::kDirect, Aov::kIndirect};
  const MadeFrames made = make_frames(layered, {1});
  EXPECT_EQ(made.film(1), make_frames(paths(2, GetParam()), {1}).film(1));
  for (const Aov layer : layered.sampling.aov) EXPECT_FALSE(made.frames.at(1).pictures.aovs[layer].data.empty());
}

TEST_P(PathTracedFrames, are_traced_in_full_and_count_their_rays) {
  const FrameReport report = make_frames(paths(2, GetParam()), {0}).report(0);
  EXPECT_EQ(report.kind, "full");
  EXPECT_GE(report.rays.primary, 2u * 64 * 64);
  EXPECT_GT(report.rays.indirect, 0u);
  EXPECT_GT(report.rays.shadow, 0u);
}

INSTANTIATE_TEST_SUITE_P(, PathTracedFrames, testing::Values(Denoise::kAuto, Denoise::kNone),
                         [](const auto& denoise) { return denoise.param == Denoise::kAuto ? "denoised" : "as_traced"; });

TEST(DenoisedFrames, reduce_the_error_by_default) { expect_less_noise(paths(4), 3); }

TEST(DenoisedFrames, with_depth_of_field_reduce_the_error) {
  RenderParams params = paths(4, Denoise::kAuto, "room");
  params.optics = {.kind = OpticsKind::kMultiview, .size = {128, 48}, .views = {2, 1}};
  params.sampling.lens.aperture_mm = 20.0f;
  expect_less_noise(params, 0);
}

TEST(DenoisedFrames, with_motion_blur_reduce_the_error) {
  RenderParams params = paths(4);
  params.sampling.shutter = 0.5f;
  expect_less_noise(params, 3);
}

TEST(DenoisedFrames, of_one_sample_stay_as_traced) {
  EXPECT_EQ(make_frames(paths(1), {0}).film(0), make_frames(paths(1, Denoise::kNone), {0}).film(0));
}

TEST(DenoisedFrames, of_whitted_shading_stay_as_traced) {
  RenderParams params = paths(4), plain = paths(4, Denoise::kNone);
  for (RenderParams* p : {&params, &plain}) p->sampling.integrator = Integrator::kWhitted;
  EXPECT_EQ(make_frames(params, {0}).film(0), make_frames(plain, {0}).film(0));
}

}  // namespace
}  // namespace lippmann::test

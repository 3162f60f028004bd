// How much of a frame's error an eye sees through lenses that mix neighbours.
#include "radiance/eye_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/image/encode.hpp"
#include "radiance/cached_light.hpp"
#include "radiance/measured_codes.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kViews = 16, kTile = 16;

/// Views side by side, so that neighbours of a pixel lie a tile away.
Optics views_of(int count = kViews) {
  Optics optics;
  optics.panel = {count * kTile, kTile, 4.0f / kTile};
  MultiView views;
  views.columns = count, views.rows = 1, views.distance_mm = 10.0f, views.view_cone = radians(20.0f);
  optics.model = views;
  return optics;
}

/// A matt floor and wall below a sky, by paths.
class SeenSky : public testing::Test {
 protected:
  SeenSky() : s_(scene()), device_(s_.scene, pool_, Integrator::kPath) {
    device_.update(evaluate(s_.scene, 0.0), pool_);
    params_.max_depth = 3, params_.spp = 16;
  }

  Image traced(int spp, std::uint32_t seed) const {
    TraceParams params = params_;
    params.spp = spp, params.seed = seed;
    Image film;
    trace_frame(shot(), params, {pool_, context_}, {film});
    return film;
  }

  Shot shot() const { return {device_, optics_, {}}; }

  PixelMeasure pixels(const Image& film) const {
    return {shot(), params_, choose_pixels(film, {1u << 20, 1, 1}, {}, 7), 2, {pool_, context_}};
  }

  EyeWeights weights(const Image& film, double sigma_px) const { return {EyeBlur(optics_, sigma_px), film, pool_}; }

  EyeMeasure at_eye(const Image& film, double sigma_px, const PixelMeasure& pixels) const {
    return {weights(film, sigma_px), pixels, shot(), params_, {pool_, context_}};
  }

  /// `film` with codes that are wrong by `step` in views of even number and by `odd_step` in the others.
  static Image with_error(Image film, double step, double odd_step) {
    for (std::size_t i = 0; i < film.data.size(); ++i) {
      const std::size_t view = i / 3 % static_cast<std::size_t>(film.width) / kTile;
      const double code = srgb_from_linear(film.data[i]) + (view % 2 == 0 ? step : odd_step);
      film.data[i] = static_cast<float>(linear_from_srgb(code));
    }
    return film;
  }

  static SmallScene scene() {
    SmallScene s;
    s.scene.max_depth = 3;
    s.scene.background.horizon = {0.7f, 0.6f, 0.5f};
    s.scene.background.zenith = {0.3f, 0.4f, 0.6f};
    s.add(Boxes{{{-4.0f, -1.2f, -4.0f}, {4.0f, -1.0f, 4.0f}}, {{-4.0f, -4.0f, -4.0f}, {4.0f, 4.0f, -3.0f}}},
          s.material(matte(Vec3f(0.5f))));
    return s;
  }

  ThreadPool pool_{2};
  Context context_;
  SmallScene s_;
  Optics optics_ = views_of();
  DeviceScene device_;
  TraceParams params_;
};

// In a picture of one colour, what an eye sees of an error that all pixels share is all of it.
TEST_F(SeenSky, weights_of_a_pixel_and_all_others_add_up_to_the_squared_slope) {
  Image grey(optics_.panel.width, optics_.panel.height, 3);
  std::fill(grey.data.begin(), grey.data.end(), 0.2f);
  const EyeWeights weights = this->weights(grey, 0.5);
  const std::uint32_t middle = kTile * kViews * 5 + kTile * (kViews / 2) + 3;
  double sum = 0.0;
  for (int step = -8; step < 8; ++step) sum += weights.of_pair(middle, {step, 0}).x;
  const double slope = slope_of_code(0.2);
  EXPECT_NEAR(sum, slope * slope, 1e-5 * slope * slope);
  EXPECT_NEAR(weights.of_pair(middle, Vec2i(0)).x, weights.blur().own_share() * slope * slope, 1e-5 * slope * slope);
}

// Paths of different pixels err independently: of N equal weights 1 / N is left, 10 log10 N dB. A Gaussian of sigma 2 has 7.1
// (2 sqrt(pi) sigma); at the outermost views, which have fewer neighbours, a little more is left.
TEST_F(SeenSky, independent_errors_fall_by_as_many_pixels_as_are_seen_at_once) {
  const Image film = traced(64, 3);
  const PixelMeasure pixels = this->pixels(film);
  const double single = static_cast<double>(pixels.of_paths().squared);
  const EyeBlur blur(optics_, 2.0);
  double share = 0.0;  // by view, of the weights within the quilt
  for (int view = 0; view < kViews; ++view) {
    double weights = 0.0, squares = 0.0;
    for (int other = 0; other < kViews; ++other) {
      const double weight = blur.weight({other - view, 0});
      weights += weight, squares += weight * weight;
    }
    share += squares / (weights * weights) / kViews;
  }
  EXPECT_NEAR(1.0 / blur.own_share(), 7.1, 0.1);
  const PixelError seen = at_eye(film, 2.0, pixels).of_paths();
  EXPECT_NEAR(static_cast<double>(seen.squared), share * single, 0.1 * share * single);
}

TEST_F(SeenSky, errors_that_neighbours_share_are_seen_whole) {
  const Image right = traced(256, 3);
  const PixelMeasure pixels = this->pixels(right);
  constexpr double kStep = 8.0 / 255.0;
  for (const double sigma : {0.39, 1.5}) {
    const PixelError seen = at_eye(right, sigma, pixels).error_of(with_error(right, kStep, kStep));
    EXPECT_NEAR(static_cast<double>(seen.squared), kStep * kStep,
                4.0 * static_cast<double>(seen.uncertainty) + 0.04 * kStep * kStep)
        << sigma;
  }
}

// Of +d, -d, +d ... an eye sees w_0 - 2 w_1 + ... of d: at 10 % of each neighbour 0.6, and 0.36 of the squared error, where
// independent errors would leave 0.66.
TEST_F(SeenSky, errors_of_neighbours_that_are_opposite_cancel) {
  const Image right = traced(256, 3);
  const PixelMeasure pixels = this->pixels(right);
  constexpr double kStep = 6.0 / 255.0;
  const PixelError seen = at_eye(right, 0.39, pixels).error_of(with_error(right, kStep, -kStep));
  // The outermost views have one neighbour: 0.78 of d.
  const double expected = (14.0 * 0.36 + 2.0 * std::pow((0.8 - 0.1) / 0.9, 2)) / 16.0;
  EXPECT_NEAR(static_cast<double>(seen.squared) / (kStep * kStep), expected,
              4.0 * static_cast<double>(seen.uncertainty) / (kStep * kStep) + 0.03);
  EXPECT_LT(seen.squared, 0.55f * static_cast<float>(kStep * kStep));
}

/// The reports of a history of frames of cached light.
std::vector<CachedLightReport> reports_of(const Scene& scene, const Optics& optics, const ErrorGoal& error) {
  const ThreadPool pool(2);
  const Context context;
  DeviceScene device(scene, pool, Integrator::kPath);
  CachedLightTracer tracer(device);
  TraceParams params;
  params.max_depth = scene.max_depth, params.spp = 64;
  const ResolvedScene resolved = evaluate(scene, 0.0);
  device.update(resolved, pool);
  std::vector<CachedLightReport> reports;
  for (std::uint32_t frame = 0; frame < 3; ++frame) {
    params.frame = frame;
    Image film;
    reports.push_back(
        tracer.trace({device, optics, {}}, resolved, params, {.error = error, .frames = 3}, {}, {pool, context}, {film}));
  }
  return reports;
}

TEST_F(SeenSky, without_neighbours_an_eye_sees_what_single_pixels_err_by) {
  for (const bool at_eye : {false, true}) {
    const std::vector<CachedLightReport> sharp = reports_of(s_.scene, optics_, {.at_eye = at_eye}),
                                         single =
                                             reports_of(s_.scene, single_view(64), {.crosstalk_px = 0.4, .at_eye = at_eye});
    for (const std::vector<CachedLightReport>& reports : {sharp, single})
      for (const CachedLightReport& report : reports) {
        EXPECT_GT(report.pixels.squared, 0.0f);
        EXPECT_EQ(report.at_eye.squared, report.pixels.squared);
        EXPECT_EQ(report.at_eye.uncertainty, report.pixels.uncertainty);
      }
  }
}

TEST_F(SeenSky, a_goal_at_the_eye_is_held_there_and_leaves_more_noise_in_pixels) {
  constexpr float kGoal = 4e-5f;  // 44 dB
  const std::vector<CachedLightReport> pixels = reports_of(s_.scene, optics_, {.squared = kGoal, .crosstalk_px = 0.6}),
                                       eye = reports_of(s_.scene, optics_,
                                                        {.squared = kGoal, .crosstalk_px = 0.6, .at_eye = true});
  std::uint64_t rays_of_pixels = 0, rays_of_eye = 0;
  float mean = 0.0f;  // what is measured of a single frame is known to a fifth of the goal
  for (std::size_t f = 0; f < pixels.size(); ++f) {
    EXPECT_LT(pixels[f].at_eye.squared, pixels[f].pixels.squared);
    EXPECT_LT(eye[f].at_eye.squared - 2.0f * eye[f].at_eye.uncertainty, 1.3f * kGoal);
    mean += eye[f].at_eye.squared / static_cast<float>(eye.size());
    rays_of_pixels += pixels[f].rays.total(), rays_of_eye += eye[f].rays.total();
  }
  EXPECT_LT(mean, 1.2f * kGoal);
  EXPECT_LT(rays_of_eye, rays_of_pixels);
}

}  // namespace
}  // namespace lippmann

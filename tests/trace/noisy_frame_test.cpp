#include "trace/noisy_frame.hpp"

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kNoisySize = 32;

NoisyFrame traced(const Scene& scene, int spp, const Affine3f& world_from_display = {}) {
  const ThreadPool pool(2);
  DeviceScene device(scene, pool, Integrator::kPath);
  TraceParams params;
  params.spp = spp, params.max_depth = scene.max_depth;
  NoisyFrame noisy;
  FrameAovs none;
  trace_noisy_frame({device, single_view(kNoisySize), world_from_display}, params, {pool, Context{}}, noisy, none);
  return noisy;
}

double mean_square(const Image& a) {
  double sum = 0.0;
  for (const float v : a.data) sum += static_cast<double>(v) * static_cast<double>(v);
  return sum / static_cast<double>(a.data.size());
}

TEST(NoisyFrame, film_equals_the_frames_film) {
  const SmallScene s = busy_scene(3);
  for (const int spp : {3, 4})
    EXPECT_EQ(traced(s.scene, spp).film.data, trace_paths(s.scene, single_view(kNoisySize), spp).film.data);
}

// The noise is estimated from the difference between two halves of the samples. Stratified halves fill each other's
// gaps, so the estimate may exceed the error of their mean.
TEST(NoisyFrame, noise_matches_the_errors_without_bias) {
  const SmallScene s = busy_scene(3);
  const Image truth = trace_paths(s.scene, single_view(kNoisySize), 1024).film;
  for (const int spp : {3, 8, 16}) {
    const NoisyFrame noisy = traced(s.scene, spp);
    Image error = noisy.film;
    double sum = 0.0;
    for (std::size_t i = 0; i < error.data.size(); ++i) {
      error.data[i] -= truth.data[i];
      sum += static_cast<double>(noisy.noise.data[i]);
    }
    const double estimated = mean_square(noisy.noise), actual = mean_square(error),
                 count = static_cast<double>(error.data.size());
    EXPECT_GT(estimated, 0.7 * actual) << spp;
    EXPECT_LT(estimated, 3.0 * actual) << spp;
    EXPECT_LT(std::abs(sum / count), 4.0 * std::sqrt(estimated / (count / 3.0))) << spp;
  }
}

// The square's edge at x = 1.05 covers 0.4 of pixel 24, from x = 1 to 1.125. In `moved`, the display is 2 mm behind the
// square.
TEST(NoisyFrame, surfaces_are_averaged_over_samples) {
  SmallScene s;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.25f);
  s.add(square(1.05f, 0), s.material(matte({0.5f, 0.25f, 1.0f})));
  const NoisyFrame noisy = traced(s.scene, 64);
  const float met = noisy.met.pixel(24, 16)[0];
  EXPECT_NEAR(met, 0.4f, 1.0f / 64);
  EXPECT_NEAR(noisy.albedo.pixel(24, 16)[0], 0.5f * met, 1e-5f);
  EXPECT_NEAR(noisy.normal.pixel(24, 16)[2], met, 1e-5f);
  EXPECT_NEAR(noisy.seen.pixel(24, 16)[1], 0.25f * (1.0f - met), 1e-5f);
  const NoisyFrame moved = traced(s.scene, 4, {Mat3f(1.0f), {0.0f, 0.0f, -2.0f}});
  EXPECT_NEAR(moved.z.pixel(16, 16)[0], 2.0f, 1e-5f);
}

TEST(NoisyFrame, emission_of_the_first_surface_is_noise_free) {
  SmallScene s;
  PhongSurface lamp = matte(Vec3f(0.5f));
  lamp.emission = Vec3f(3.0f);
  s.add(square(1, 0), s.material(lamp));
  EXPECT_NEAR(traced(s.scene, 4).seen.pixel(16, 16)[0], 3.0f, 1e-5f);
}

}  // namespace
}  // namespace lippmann

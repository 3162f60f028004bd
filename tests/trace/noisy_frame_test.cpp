#include "trace/noisy_frame.hpp"

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kSize = 32;

NoisyFrame traced(const Scene& scene, int spp, const Affine3f& world_from_display = {}) {
  const ThreadPool pool(2);
  DeviceScene device(scene, pool, Integrator::kPath);
  TraceParams params;
  params.spp = spp, params.max_depth = scene.max_depth;
  NoisyFrame noisy;
  FrameAovs none;
  trace_noisy_frame(device, single_view(kSize), world_from_display, params, pool, Context{}, noisy, none);
  return noisy;
}

TEST(NoisyFrame, film_is_that_of_the_frame_and_halves_are_parts_of_it) {
  const SmallScene s = busy_scene(3);
  const NoisyFrame noisy = traced(s.scene, 4);
  EXPECT_EQ(noisy.film.data, trace_paths(s.scene, single_view(kSize), 4).film.data);
  double odd = 0.0, all = 0.0;
  for (std::size_t i = 0; i < noisy.film.data.size(); ++i) {
    ASSERT_LE(noisy.odd.data[i], noisy.film.data[i] * 1.0001f) << i;
    odd += static_cast<double>(noisy.odd.data[i]), all += static_cast<double>(noisy.film.data[i]);
  }
  EXPECT_NEAR(odd / all, 0.5, 0.02);
}

// The square's edge runs through pixel 24 at 0.4 of it, as in the tests of alpha; it lies 2 mm before the display's plane.
TEST(NoisyFrame, surfaces_are_averaged_over_the_samples_of_a_pixel) {
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

TEST(NoisyFrame, light_that_shines_from_the_first_surface_is_seen_without_noise) {
  SmallScene s;
  PhongSurface lamp = matte(Vec3f(0.5f));
  lamp.emission = Vec3f(3.0f);
  s.add(square(1, 0), s.material(lamp));
  EXPECT_NEAR(traced(s.scene, 4).seen.pixel(16, 16)[0], 3.0f, 1e-5f);
}

}  // namespace
}  // namespace lippmann

// With alpha, the background lights the scene but is invisible. The camera at (0, 0, 10) sees the square from -2 to 2
// in x and y at z = 0.
#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kTransparentSize = 32;
const Integrator kBoth[] = {Integrator::kWhitted, Integrator::kPath};

Picture traced(const Scene& scene, Integrator integrator, int spp, bool transparent = true) {
  const ThreadPool pool(2);
  DeviceScene device(scene, pool, integrator);
  TraceParams params;
  params.spp = spp, params.max_depth = scene.max_depth;
  Picture p;
  if (transparent) p.aovs.want(Aov::kAlpha);
  trace_frame({device, single_view(kTransparentSize), {}}, params, {pool, Context{}}, {p.film, &p.aovs});
  return p;
}

float alpha(const Picture& p, int x, int y) { return p.aovs[Aov::kAlpha].pixel(x, y)[0]; }

SmallScene square_before_grey(const auto& surface) {
  SmallScene s;
  s.scene.max_depth = 4;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.5f);
  s.add(square(1, 0), s.material(surface));
  s.point_light({0, 0, 4});
  return s;
}

TEST(Transparent, hits_are_unchanged_and_misses_empty) {
  const Scene scene = square_before_grey(matte(Vec3f(0.8f))).scene;
  for (const Integrator integrator : kBoth) {
    const Picture p = traced(scene, integrator, 4), opaque = traced(scene, integrator, 4, false);
    EXPECT_EQ(alpha(p, 16, 16), 1.0f);
    EXPECT_EQ(p.at(16, 16), opaque.at(16, 16));
    EXPECT_EQ(alpha(p, 2, 2), 0.0f);
    EXPECT_EQ(p.at(2, 2), Vec3f(0.0f));
    EXPECT_EQ(opaque.at(2, 2), Vec3f(0.5f));
  }
}

// The square's edge at x = 1.05 covers 0.4 of pixel 24, from x = 1 to 1.125.
TEST(Transparent, edges_have_partial_alpha) {
  SmallScene s;
  s.add(square(1.05f, 0), s.material(glowing(Vec3f(1.0f))));
  for (const Integrator integrator : kBoth) {
    const Picture p = traced(s.scene, integrator, 64);
    EXPECT_NEAR(alpha(p, 24, 16), 0.4f, 1.0f / 64);  // the samples are 1/64 of a pixel apart
    EXPECT_NEAR(p.at(24, 16).x, alpha(p, 24, 16), 1e-5f) << "colours are multiplied by alpha";
  }
}

TEST(Transparent, blended_surfaces_have_partial_alpha) {
  MetallicRoughness veil;
  veil.base_color.a = 0.25f, veil.blend = true, veil.unlit = true;
  const Scene scene = square_before_grey(veil).scene;
  EXPECT_EQ(alpha(traced(scene, Integrator::kWhitted, 1), 16, 16), 0.25f);
  EXPECT_NEAR(traced(scene, Integrator::kWhitted, 1).at(16, 16).x, 0.25f, 1e-6f);
  EXPECT_NEAR(alpha(traced(scene, Integrator::kPath, 1024), 16, 16), 0.25f, 0.05f);  // 3.7 standard deviations
}

TEST(Transparent, masked_parts_are_empty_glass_is_not) {
  MetallicRoughness cut, glass;
  cut.base_color.a = 0.25f, cut.alpha_cutoff = 0.5f;
  glass.transmission = 1.0f, glass.roughness = 0.0f, glass.metallic = 0.0f;
  for (const Integrator integrator : kBoth) {
    const Picture gone = traced(square_before_grey(cut).scene, integrator, 2);
    EXPECT_EQ(alpha(gone, 16, 16), 0.0f);
    EXPECT_EQ(gone.at(16, 16), Vec3f(0.0f));
    const Picture pane = traced(square_before_grey(glass).scene, integrator, 16);
    EXPECT_EQ(alpha(pane, 16, 16), 1.0f);
    EXPECT_GT(pane.at(16, 16).x, 0.3f) << "the background, through the pane";
  }
}

TEST(Transparent, surroundings_still_light_the_scene) {
  SmallScene s;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.5f);
  s.add(square(1, 0), s.material(matte(Vec3f(0.8f))));
  EXPECT_NEAR(traced(s.scene, Integrator::kPath, 64).at(16, 16).x, 0.4f, 0.01f);
}

}  // namespace
}  // namespace lippmann

// Shared light of lamps that have a size, against frames of paths.
#include <gtest/gtest.h>

#include <cmath>

#include "radiance/cached_light.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kSize = 48, kRenders = 6, kBands = 6;

MetallicRoughness surface_of(Vec3f color, float metallic, float roughness) {
  MetallicRoughness m;
  m.base_color = Vec4f(color, 1.0f);
  m.metallic = metallic, m.roughness = roughness, m.specular = metallic;
  return m;
}

void add_wall(SmallScene& s, Vec3f a, Vec3f b, Vec3f c, Vec3f d, int material) {
  Mesh m;
  m.positions = {a, b, c, d};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.add(m, material);
}

/// A post and a ball of rough metal in a corner of three walls, below `lamps` balls of light in a row and a sun from the right.
/// radius 0: points, and no sun.
SmallScene corner(int lamps, float radius = 0.3f) {
  SmallScene s;
  s.scene.max_depth = 5;
  const int white = s.material(surface_of(Vec3f(0.7f), 0.0f, 1.0f)),
            red = s.material(surface_of({0.6f, 0.1f, 0.1f}, 0.0f, 1.0f));
  add_wall(s, {-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}, white);
  add_wall(s, {-2, -2, 2}, {2, -2, 2}, {2, -2, -2}, {-2, -2, -2}, white);
  add_wall(s, {-2, -2, 2}, {-2, -2, -2}, {-2, 2, -2}, {-2, 2, 2}, red);
  s.add(Boxes{{{-0.4f, -2.0f, -0.6f}, {0.0f, 0.2f, -0.2f}}}, white);
  s.add(Spheres{{{0.9f, -1.3f, 0.2f}, 0.7f}}, s.material(surface_of(Vec3f(0.9f), 1.0f, 0.3f)));
  for (int l = 0; l < lamps; ++l) {
    Light& light = s.point_light({-1.2f + 2.4f * static_cast<float>(l) / static_cast<float>(lamps), 1.4f, 1.0f},
                                 Vec3f(6.0f / static_cast<float>(lamps)));
    light.inverse_square = true;
    light.radius = radius;
  }
  if (radius == 0.0f) return s;
  Light& sun = s.point_light(Vec3f(0.0f), Vec3f(0.5f));
  const Vec3f z = glm::normalize(Vec3f(1.0f, 1.0f, 0.8f)), x = glm::normalize(glm::cross(Vec3f(0, 1, 0), z));
  s.scene.nodes.back().matrix = Affine3f{Mat3f(x, glm::cross(z, x), z), Vec3f(0.0f)};
  sun.kind = LightKind::kDirectional;
  sun.angular_diameter = radians(10.0f);
  return s;
}

/// The second frame of a history; whether it shares light.
std::pair<Image, bool> shared_frame(const Scene& scene, std::uint32_t seed) {
  const ThreadPool pool(1);
  const Context context;
  DeviceScene device(scene, pool, Integrator::kPath);
  CachedLightTracer tracer(device);
  TraceParams params;
  params.seed = seed, params.max_depth = scene.max_depth, params.spp = 64;
  CachedLightGoal goal{.error = {.squared = 4e-4f}};
  goal.frames = 16;
  const ResolvedScene resolved = evaluate(scene, 0.0);
  Image film;
  bool shares = false;
  for (std::uint32_t frame = 0; frame < 2; ++frame) {
    params.frame = frame;
    shares = !tracer.trace({device, single_view(kSize), {}}, resolved, params, goal, {}, {pool, context}, {film}).traced;
  }
  return {std::move(film), shares};
}

struct Samples {
  double sum = 0.0, squares = 0.0;
  void add(double x) { sum += x, squares += x * x; }
  double mean() const { return sum / kRenders; }
  double variance_of_mean() const { return std::max(0.0, squares / kRenders - mean() * mean()) / (kRenders - 1); }
};

void add_bands(const Image& film, std::vector<Samples>& bands) {
  constexpr std::size_t kBand = 3 * kSize * kSize / kBands;
  for (std::size_t b = 0; b < kBands; ++b) {
    const auto first = film.data.begin() + static_cast<std::ptrdiff_t>(b * kBand);
    bands[b].add(std::accumulate(first, first + kBand, 0.0) / kBand);
  }
}

// Bands of the picture: |t| below 4.5, which chance exceeds once in 800 tests of 10 degrees of freedom, and 0.5 % for what
// cells blur, as of point-like lights (cached_light_test.cpp).
void expect_the_light_of_paths(const SmallScene& s, int lamps) {
  std::vector<Samples> paths(kBands), shared(kBands);
  for (std::uint32_t seed = 0; seed < kRenders; ++seed) {
    TraceParams params;
    params.seed = seed;
    add_bands(trace_paths(s.scene, single_view(kSize), 64, params).film, paths);
    const auto [film, shares] = shared_frame(s.scene, seed);
    ASSERT_TRUE(shares);
    add_bands(film, shared);
  }
  for (std::size_t b = 0; b < kBands; ++b) {
    const double most = 4.5 * std::sqrt(paths[b].variance_of_mean() + shared[b].variance_of_mean()) + 0.005 * paths[b].mean();
    EXPECT_NEAR(shared[b].mean(), paths[b].mean(), most) << lamps << " lamps, band " << b;
    EXPECT_GT(paths[b].mean(), 0.01) << b;
  }
}

// Two lamps are each asked at every point, of six one, which a tree draws.
TEST(CachedLight, of_lamps_that_have_a_size_has_the_mean_light_of_paths) {
  for (const int lamps : {2, 6}) expect_the_light_of_paths(corner(lamps), lamps);
}

TEST(CachedLight, of_many_points_has_the_mean_light_of_paths) { expect_the_light_of_paths(corner(40, 0.0f), 40); }

}  // namespace
}  // namespace lippmann

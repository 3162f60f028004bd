// The camera at (0, 0, 10) sees the square from -2 to 2 in x and y at z = 0, with 32 pixels of width 1/8.
#include <gtest/gtest.h>

#include <tuple>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kAovSize = 32;
constexpr float kPlaceRounding = 1e-4f;  ///< in pixels: rounding of positions about 10 mm from the origin

FrameAovs step(const Scene& scene, const Optics& optics, double before, double now, const Affine3f& display_before = {},
               const Affine3f& display_now = {}) {
  const ThreadPool pool(1);
  DeviceScene device(scene, pool);
  const ResolvedScene then = evaluate(scene, before), at = evaluate(scene, now);
  device.update(at, pool);
  FrameAovs aovs;
  for (const Aov aov : {Aov::kMotion, Aov::kId}) aovs.want(aov);
  const FrameStep frame_step{at, then, display_before};
  find_first_hits({device, optics, display_now}, RayOrder::kRows, &frame_step, pool, aovs);
  return aovs;
}

void expect_motion(const FrameAovs& aovs, int x, int y, Vec2f expected) {
  const float* motion = aovs[Aov::kMotion].pixel(x, y);
  EXPECT_NEAR(motion[0], expected.x, kPlaceRounding) << x << ", " << y;
  EXPECT_NEAR(motion[1], expected.y, kPlaceRounding) << x << ", " << y;
}

Scene sliding(float z, Vec3f shift) {
  SmallScene s;
  s.add(square(1, z), s.material(glowing(Vec3f(1.0f))), s.moving_node(Vec3f(0.0f), shift));
  return s.scene;
}

TEST(Aovs, motion_of_a_square_is_in_pixels) {
  expect_motion(step(sliding(0.0f, {0.375f, -0.25f, 0.0f}), single_view(kAovSize), 0.0, 1.0), 16, 16, {3, 2});
  // At z = 5, half-way to the eye, everything appears twice as large.
  expect_motion(step(sliding(5.0f, {0.375f, -0.25f, 0.0f}), single_view(kAovSize), 0.0, 1.0), 16, 16, {6, 4});
}

TEST(Aovs, motion_of_static_pixels_is_zero) {
  const FrameAovs aovs = step(sliding(0.0f, {0.375f, 0.0f, 0.0f}), single_view(kAovSize), 0.0, 1.0);
  EXPECT_EQ(aovs[Aov::kMotion].pixel(0, 0)[0], 0.0f);
  EXPECT_EQ(aovs[Aov::kId].pixel(0, 0)[0], -1.0f);
  const FrameAovs still = step(sliding(0.3f, Vec3f(0.0f)), single_view(kAovSize), 0.0, 1.0);
  EXPECT_EQ(still[Aov::kMotion].data, std::vector<float>(2 * kAovSize * kAovSize, 0.0f));
}

TEST(Aovs, motion_of_static_objects_opposes_the_displays) {
  const Affine3f moved{Mat3f(1.0f), {0.375f, 0.0f, 0.0f}};
  expect_motion(step(sliding(0.0f, Vec3f(0.0f)), single_view(kAovSize), 0.0, 1.0, {}, moved), 16, 16, {-3, 0});
}

// Pixel (8, 16) sees the point (-0.9375, -0.0625, 0). Before, at z = -1, the point appeared at 10/11 of these
// coordinates. In pixels of 1/8, the point has moved by (-7.5, 0.5) (1 - 10/11).
TEST(Aovs, motion_towards_the_viewer_points_outwards) {
  const FrameAovs aovs = step(sliding(-1.0f, {0.0f, 0.0f, 1.0f}), single_view(kAovSize), 0.0, 1.0);
  expect_motion(aovs, 8, 16, {-7.5f / 11.0f, 0.5f / 11.0f});
}

TEST(Aovs, motion_below_lenses_is_in_view_samples) {
  for (const float z : {0.0f, 2.0f, -3.0f})
    for (const int x : {46, 49}) {  // 1 mm across is 2 lenses of 0.5 mm, and 0.125 mm upwards is 2 rows
      const FrameAovs aovs = step(sliding(z, {1.0f, 0.125f, 0.0f}), lenticular_view(), 0.0, 1.0);
      ASSERT_EQ(aovs[Aov::kId].pixel(x, 25)[0], 0.0f);
      expect_motion(aovs, x, 25, {2, -2});
    }
}

// A pixel at the offset o from the centre of its lens has a ray of slope -o / 16. A point that comes nearer by 1 mm
// moves by o / 16 mm, which is o / 16 / 0.5 lenses.
TEST(Aovs, motion_towards_viewers_depends_on_the_view) {
  const FrameAovs aovs = step(sliding(0.0f, {0.0f, 0.0f, 1.0f}), lenticular_view(), 0.0, 1.0);
  for (int x = 24; x < 40; ++x) {
    const float offset = static_cast<float>(x % 8) - 3.5f;
    expect_motion(aovs, x, 25, {offset / 16.0f / 0.5f, 0.0f});
  }
}

// The square's half size grows from 0.5 to 1, so a point now at x was at x / 2.
TEST(Aovs, motion_follows_deforming_meshes) {
  SmallScene s;
  Mesh growing = square(0.5f, 0);
  growing.targets.resize(1);
  for (const Vec3f& p : growing.positions) growing.targets[0].positions.push_back(Vec3f(p.x, p.y, 0));
  const int node = s.moving_node({0, 0, 0}, {0, 0, 0});
  s.scene.nodes[static_cast<std::size_t>(node)].morph_weights = {0.0f};
  s.scene.timeline.animations.back().morph_weights = {{0.0, 1.0}, {0.0f, 1.0f}, Interpolation::kLinear};
  s.add(growing, s.material(glowing(Vec3f(1.0f))), node);
  const FrameAovs aovs = step(s.scene, single_view(kAovSize), 0.0, 1.0);
  expect_motion(aovs, 20, 12, {0.5f * 4.5f, -0.5f * 3.5f});
  expect_motion(aovs, 9, 20, {-0.5f * 6.5f, 0.5f * 4.5f});
}

Texture four_texels(std::array<int, 4> alpha) {
  Texture t;
  t.width = 4, t.height = 1, t.srgb = false;
  for (std::size_t i = 0; i < 4; ++i)
    for (const int v : {static_cast<int>(85 * i), 255, 0, alpha[i]}) t.rgba.push_back(static_cast<std::uint8_t>(v));
  t.wrap_u = t.wrap_v = Wrap::kClamp;
  return t;
}

Scene textured(std::array<int, 4> alpha, const MetallicRoughness& kind) {
  SmallScene s;
  s.scene.textures.push_back(four_texels(alpha));
  MetallicRoughness m = kind;
  m.base_color_map.texture = 0;
  s.add(square(2, 0), s.material(m));
  s.add(square(4, -1), s.material(matte(Vec3f(0.25f))));
  return s.scene;
}

TEST(Aovs, albedo_is_the_textured_base_colour) {
  MetallicRoughness half;
  half.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
    const Picture p = trace(textured({255, 255, 255, 255}, half), single_view(kAovSize), {}, 1, 0.0, {}, integrator);
    for (const auto& [x, red] : {std::pair(4, 0.0f), {12, 85 / 510.0f}, {20, 170 / 510.0f}, {28, 0.5f}}) {
      // Each texel is 8 pixels wide, with its centre between two pixels. The tested pixels are 1/16 of a texel from a
      // centre.
      EXPECT_NEAR(p.aovs[Aov::kAlbedo].pixel(x, 16)[0], red, 85 / 510.0f / 15.0f);
      EXPECT_NEAR(p.aovs[Aov::kAlbedo].pixel(x, 16)[1], 0.5f, 1e-5f);
    }
  }
}

TEST(Aovs, pixels_of_low_alpha_are_empty) {
  MetallicRoughness mask, blend, glass;
  mask.alpha_cutoff = 0.75f;
  blend.blend = true;
  glass.blend = true, glass.transmission = 1.0f;
  for (const auto& [kind, alpha, id] : {std::tuple(mask, 180, 1.0f), {mask, 200, 0.0f}, {blend, 120, 1.0f}, {blend, 140, 0.0f}})
    for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
      const Picture p = trace(textured({alpha, alpha, alpha, alpha}, kind), single_view(kAovSize), {}, 1, 0.0, {}, integrator);
      EXPECT_EQ(p.aovs[Aov::kId].pixel(16, 16)[0], id) << alpha;
      EXPECT_NEAR(p.aovs[Aov::kDepth].pixel(16, 16)[0], -id, 1e-5f) << alpha;
      EXPECT_NEAR(p.aovs[Aov::kAlbedo].pixel(16, 16)[1], id == 1.0f ? 0.25f : 1.0f, 1e-5f) << alpha;
    }
  const Picture p = trace(textured({255, 255, 255, 255}, glass), single_view(kAovSize));
  EXPECT_EQ(p.aovs[Aov::kId].pixel(16, 16)[0], 0.0f);
}

TEST(Aovs, ray_depth_is_measured_along_the_ray) {
  const Picture p = trace(sliding(1.0f, Vec3f(0.0f)), single_view(kAovSize));
  // The square is at z = 1 and the eye at z = 10, so the ray ends after 0.9 of its way to the plane z = 0.
  const float x = 3.5f / 8.0f, y = 0.5f / 8.0f;
  EXPECT_NEAR(p.aovs[Aov::kRayDepth].pixel(19, 16)[0], 0.9f * std::sqrt(x * x + y * y + 100.0f), 1e-5f);
  EXPECT_EQ(p.aovs[Aov::kRayDepth].pixel(0, 0)[0], kInfinity);
}

TEST(Aovs, direct_and_indirect_light_sum_to_the_film) {
  SmallScene s = busy_scene(3);
  s.scene.max_depth = 5;
  s.scene.background.horizon = Vec3f(0.2f);
  const Picture p = trace_paths(s.scene, single_view(kAovSize), 4);
  double indirect = 0.0;
  for (std::size_t i = 0; i < p.film.data.size(); ++i) {
    const float sum = p.aovs[Aov::kDirect].data[i] + p.aovs[Aov::kIndirect].data[i];
    ASSERT_NEAR(sum, p.film.data[i], 1e-5f * (1.0f + p.film.data[i])) << i;  // rounding of a sum of about 50 floats
    indirect += static_cast<double>(p.aovs[Aov::kIndirect].data[i]);
  }
  EXPECT_GT(indirect, 0.0);
}

TEST(Aovs, light_of_one_scattering_is_direct) {
  SmallScene s;
  s.scene.max_depth = 1;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.5f);
  s.add(square(1, 0), s.material(matte(Vec3f(0.5f))));
  s.point_light({0, 0, 4});
  const Picture p = trace_paths(s.scene, single_view(kAovSize), 4);
  EXPECT_EQ(p.aovs[Aov::kDirect].data, p.film.data);
  EXPECT_EQ(p.aovs[Aov::kIndirect].data, std::vector<float>(p.film.data.size(), 0.0f));
}

TEST(Aovs, parts_of_the_light_keep_the_film) {
  const SmallScene s = busy_scene(4);
  const ThreadPool pool(2);
  DeviceScene device(s.scene, pool, Integrator::kPath);
  TraceParams params;
  params.spp = 2, params.max_depth = s.scene.max_depth;
  Image film;
  trace_frame({device, single_view(kAovSize), {}}, params, {pool, Context{}}, {film});
  EXPECT_EQ(film.data, trace_paths(s.scene, single_view(kAovSize), 2, {}, 2).film.data);
}

TEST(Aovs, layers_do_not_depend_on_threads) {
  const SmallScene s = busy_scene(5);
  const Picture one = trace_paths(s.scene, single_view(kAovSize), 2, {}, 1),
                three = trace_paths(s.scene, single_view(kAovSize), 2, {}, 3);
  for (std::size_t i = 0; i < kAovs; ++i) EXPECT_EQ(one.aovs.images[i].data, three.aovs.images[i].data) << i;
}

}  // namespace
}  // namespace lippmann

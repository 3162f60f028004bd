// Extra layers of a frame, worked out by hand. Single views are from (0, 0, 10) at the square +-2, 32 pixels of 1/8 wide.
#include <gtest/gtest.h>

#include <tuple>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kAovSize = 32;
constexpr float kPlaceRounding = 1e-4f;  ///< pixels: single precision of places some 10 mm from the middle

/// Where everything is at two times, and the layers of the second.
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

/// A square at depth z that moves by `shift` within a second.
Scene sliding(float z, Vec3f shift) {
  SmallScene s;
  s.add(square(1, z), s.material(glowing(Vec3f(1.0f))), s.moving_node(Vec3f(0.0f), shift));
  return s.scene;
}

// ---- Motion ---------------------------------------------------------------------------------------------------------

TEST(Aovs, motion_of_a_square_is_its_way_in_pixels_to_the_right_and_down) {
  expect_motion(step(sliding(0.0f, {0.375f, -0.25f, 0.0f}), single_view(kAovSize), 0.0, 1.0), 16, 16, {3, 2});
  // Half-way to the eye everything is twice as large.
  expect_motion(step(sliding(5.0f, {0.375f, -0.25f, 0.0f}), single_view(kAovSize), 0.0, 1.0), 16, 16, {6, 4});
}

TEST(Aovs, motion_is_zero_in_the_background_and_where_nothing_moves) {
  const FrameAovs aovs = step(sliding(0.0f, {0.375f, 0.0f, 0.0f}), single_view(kAovSize), 0.0, 1.0);
  EXPECT_EQ(aovs[Aov::kMotion].pixel(0, 0)[0], 0.0f);
  EXPECT_EQ(aovs[Aov::kId].pixel(0, 0)[0], -1.0f);
  const FrameAovs still = step(sliding(0.3f, Vec3f(0.0f)), single_view(kAovSize), 0.0, 1.0);
  EXPECT_EQ(still[Aov::kMotion].data, std::vector<float>(2 * kAovSize * kAovSize, 0.0f));
}

TEST(Aovs, motion_of_what_stands_is_the_display_s_own_turned_round) {
  const Affine3f moved{Mat3f(1.0f), {0.375f, 0.0f, 0.0f}};
  expect_motion(step(sliding(0.0f, Vec3f(0.0f)), single_view(kAovSize), 0.0, 1.0, {}, moved), 16, 16, {-3, 0});
}

// Pixel (8, 16) looks at x = -0.9375, y = -0.0625 in z = 0; what came from z = -1 on to there was seen at 10/11 of that.
TEST(Aovs, motion_towards_the_viewer_is_away_from_the_middle_of_the_view) {
  const FrameAovs aovs = step(sliding(-1.0f, {0.0f, 0.0f, 1.0f}), single_view(kAovSize), 0.0, 1.0);
  expect_motion(aovs, 8, 16, {-7.5f / 11.0f, 0.5f / 11.0f});
}

TEST(Aovs, motion_below_lenses_is_in_samples_of_the_view_whatever_the_depth) {
  for (const float z : {0.0f, 2.0f, -3.0f})
    for (const int x : {46, 49}) {  // two views: 1 mm is 2 lenses of 0.5 mm, 0.125 mm two rows
      const FrameAovs aovs = step(sliding(z, {1.0f, 0.125f, 0.0f}), lenticular_view(), 0.0, 1.0);
      ASSERT_EQ(aovs[Aov::kId].pixel(x, 25)[0], 0.0f);
      expect_motion(aovs, x, 25, {2, -2});
    }
}

// A view's slope below its lens is that of its pixel's offset o from the lens's middle, -o / 16; what comes nearer by z moves
// by as much as the slope takes it: z o / 16 / 0.5 lenses.
TEST(Aovs, motion_towards_the_viewer_differs_from_view_to_view) {
  const FrameAovs aovs = step(sliding(0.0f, {0.0f, 0.0f, 1.0f}), lenticular_view(), 0.0, 1.0);
  for (int x = 24; x < 40; ++x) {
    const float offset = static_cast<float>(x % 8) - 3.5f;
    expect_motion(aovs, x, 25, {offset / 16.0f / 0.5f, 0.0f});
  }
}

// From the square's corners +-0.5 to +-1: what is at x came from x / 2.
TEST(Aovs, motion_follows_meshes_that_change_their_shape) {
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

// ---- Albedo and what counts as there --------------------------------------------------------------------------------

/// Four texels in a row, their red 0, 85, 170, 255, their alpha as given.
Texture four_texels(std::array<int, 4> alpha) {
  Texture t;
  t.width = 4, t.height = 1, t.srgb = false;
  for (std::size_t i = 0; i < 4; ++i)
    for (const int v : {static_cast<int>(85 * i), 255, 0, alpha[i]}) t.rgba.push_back(static_cast<std::uint8_t>(v));
  t.wrap_u = t.wrap_v = Wrap::kClamp;
  return t;
}

/// A textured square of glTF's kind in front of another of albedo 0.25.
Scene textured(std::array<int, 4> alpha, const MetallicRoughness& kind) {
  SmallScene s;
  s.scene.textures.push_back(four_texels(alpha));
  MetallicRoughness m = kind;
  m.base_color_map.texture = 0;
  s.add(square(2, 0), s.material(m));
  s.add(square(4, -1), s.material(matte(Vec3f(0.25f))));
  return s.scene;
}

TEST(Aovs, albedo_is_the_base_colour_with_its_texture_whatever_the_light) {
  MetallicRoughness half;
  half.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
    const Picture p = trace(textured({255, 255, 255, 255}, half), single_view(kAovSize), {}, 1, 0.0, {}, integrator);
    for (const auto& [x, red] : {std::pair(4, 0.0f), {12, 85 / 510.0f}, {20, 170 / 510.0f}, {28, 0.5f}}) {
      // The middles of texels lie between pixels 3 and 4, 11 and 12, ...: 1/16 of a texel off.
      EXPECT_NEAR(p.aovs[Aov::kAlbedo].pixel(x, 16)[0], red, 85 / 510.0f / 15.0f);
      EXPECT_NEAR(p.aovs[Aov::kAlbedo].pixel(x, 16)[1], 0.5f, 1e-5f);
    }
  }
}

TEST(Aovs, what_alpha_cuts_away_or_covers_by_less_than_half_is_not_there) {
  MetallicRoughness mask, blend, glass;
  mask.alpha_cutoff = 0.75f;
  blend.blend = true;
  glass.blend = true, glass.transmission = 1.0f;  // uncovered by transmission alone: there
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

TEST(Aovs, ray_depth_is_from_the_eye_along_the_ray_and_infinite_where_nothing_is) {
  const Picture p = trace(sliding(1.0f, Vec3f(0.0f)), single_view(kAovSize));
  const float x = 3.5f / 8.0f, y = 0.5f / 8.0f;  // where pixel (19, 16) is in z = 0, 10 before the eye
  EXPECT_NEAR(p.aovs[Aov::kRayDepth].pixel(19, 16)[0], 0.9f * std::sqrt(x * x + y * y + 100.0f), 1e-5f);
  EXPECT_EQ(p.aovs[Aov::kRayDepth].pixel(0, 0)[0], kInfinity);
}

// ---- Parts of the light ---------------------------------------------------------------------------------------------

TEST(Aovs, direct_and_indirect_light_sum_to_the_film) {
  SmallScene s = busy_scene(3);
  s.scene.max_depth = 5;
  s.scene.background.horizon = Vec3f(0.2f);
  const Picture p = trace_paths(s.scene, single_view(kAovSize), 4);
  double indirect = 0.0;
  for (std::size_t i = 0; i < p.film.data.size(); ++i) {
    const float sum = p.aovs[Aov::kDirect].data[i] + p.aovs[Aov::kIndirect].data[i];
    ASSERT_NEAR(sum, p.film.data[i], 1e-5f * (1.0f + p.film.data[i])) << i;  // sums of some 50 floats
    indirect += static_cast<double>(p.aovs[Aov::kIndirect].data[i]);
  }
  EXPECT_GT(indirect, 0.0);
}

TEST(Aovs, light_that_one_surface_has_scattered_is_direct) {
  SmallScene s;
  s.scene.max_depth = 1;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.5f);
  s.add(square(1, 0), s.material(matte(Vec3f(0.5f))));
  s.point_light({0, 0, 4});
  const Picture p = trace_paths(s.scene, single_view(kAovSize), 4);
  EXPECT_EQ(p.aovs[Aov::kDirect].data, p.film.data);
  EXPECT_EQ(p.aovs[Aov::kIndirect].data, std::vector<float>(p.film.data.size(), 0.0f));
}

TEST(Aovs, parts_of_the_light_leave_the_film_as_it_is) {
  const SmallScene s = busy_scene(4);
  const ThreadPool pool(2);
  DeviceScene device(s.scene, pool, Integrator::kPath);
  TraceParams params;
  params.spp = 2, params.max_depth = s.scene.max_depth;
  Image film;
  trace_frame({device, single_view(kAovSize), {}}, params, {pool, Context{}}, {film});
  EXPECT_EQ(film.data, trace_paths(s.scene, single_view(kAovSize), 2, {}, 2).film.data);
}

TEST(Aovs, layers_are_the_same_on_any_number_of_threads) {
  const SmallScene s = busy_scene(5);
  const Picture one = trace_paths(s.scene, single_view(kAovSize), 2, {}, 1),
                three = trace_paths(s.scene, single_view(kAovSize), 2, {}, 3);
  for (std::size_t i = 0; i < kAovs; ++i) EXPECT_EQ(one.aovs.images[i].data, three.aovs.images[i].data) << i;
}

}  // namespace
}  // namespace lippmann

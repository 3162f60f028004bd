// The camera at (0, 0, 10) sees the square from -2 to 2 in x and y at z = 0. Its central rays run along -z.
#include <gtest/gtest.h>

#include "lippmann/core/error.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

// With an odd size, the centre of a pixel is on the camera's axis.
constexpr int kSize = 33, kMiddle = 16;
// rounding of single-precision shading along one path
constexpr float kRounding = 2e-5f;

TEST(Whitted, empty_scenes_show_the_background) {
  SmallScene s;
  s.scene.background.horizon = s.scene.background.zenith = {0.1f, 0.2f, 0.3f};
  const Picture p = trace(s.scene, single_view(kSize));
  expect_color(p.at(3, 5), {0.1f, 0.2f, 0.3f}, 0.0f);
  EXPECT_EQ(p.aovs[Aov::kId].data[0], -1.0f);
  EXPECT_EQ(p.aovs[Aov::kDepth].data[0], -kInfinity);
}

TEST(Whitted, background_blends_by_the_sine_of_elevation) {
  SmallScene s;
  s.scene.background = {{0, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  const Picture p = trace(s.scene, single_view(kSize));
  const float y = 2.0f * 16.0f / 16.5f;  // y of the top row's centre in the plane z = 0
  expect_color(p.at(kMiddle, 0), Vec3f(y / std::sqrt(y * y + 100.0f)), kRounding);
  expect_color(p.at(kMiddle, kSize - 1), Vec3f(0.0f), 0.0f);
}

TEST(Whitted, lambert_square_under_a_point_light) {
  SmallScene s;
  PhongSurface surface = matte({0.5f, 0.25f, 1.0f});
  surface.ambient = 0.2f;
  surface.diffuse = 0.8f;
  s.add(square(2, 0), s.material(surface));
  s.point_light({3, 0, 4}, {1.0f, 0.5f, 0.25f});
  const Picture p = trace(s.scene, single_view(kSize));
  const float n_l = 4.0f / 5.0f;
  expect_color(p.at(kMiddle, kMiddle), Vec3f(0.5f, 0.25f, 1.0f) * (Vec3f(0.2f) + 0.8f * n_l * Vec3f(1.0f, 0.5f, 0.25f)),
               kRounding);
  EXPECT_EQ(p.counts.shadow, p.counts.primary) << "the square fills the view";
}

TEST(Whitted, inverse_square_and_range_and_directional_light) {
  SmallScene s;
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  Light& light = s.point_light({0, 0, 4}, Vec3f(8.0f));
  light.inverse_square = true;
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(8.0f / 16.0f), kRounding);
  light.range = 3.9f;
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(0.0f), 0.0f);
  light.kind = LightKind::kDirectional;  // shines along -z onto the square; range and distance have no effect
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(8.0f), 1e-4f);
}

TEST(Whitted, spot_light_ends_at_its_outer_cone) {
  SmallScene s;
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  Light& light = s.point_light({0, 0, 2});
  light.kind = LightKind::kSpot;
  light.inner_cone = radians(10.0f);
  light.outer_cone = radians(30.0f);
  const Picture p = trace(s.scene, single_view(kSize));
  expect_color(p.at(kMiddle, kMiddle), Vec3f(1.0f), kRounding);
  const int outside = kMiddle + 10;  // x = 1.21, at 31 degrees from the light's axis
  expect_color(p.at(outside, kMiddle), Vec3f(0.0f), 0.0f);
  // x = 0.4848, at 13.63 degrees from the light's axis. The light is the squared linear ramp of the cosine between the cones,
  // times N.L.
  const float x = 4.0f * 4.0f / 33.0f, cosine = 2.0f / std::sqrt(x * x + 4.0f);
  const float ramp = (cosine - std::cos(radians(30.0f))) / (std::cos(radians(10.0f)) - std::cos(radians(30.0f)));
  expect_color(p.at(kMiddle + 4, kMiddle), Vec3f(ramp * ramp * cosine), 1e-4f);
}

TEST(Whitted, blinn_highlight_has_value_and_tint) {
  SmallScene s;
  PhongSurface surface = matte({0.5f, 0.25f, 1.0f});
  surface.diffuse = 0.0f;
  surface.highlight_kind = Highlight::kMetal;
  surface.highlight = 0.75f;
  surface.highlight_size = 20.0f;
  const int material = s.material(surface);
  s.add(square(2, 0), material);
  s.point_light({3, 0, 4});
  // N and the direction to the viewer are (0, 0, 1), the direction to the light L = (3, 0, 4) / 5. The half vector H is
  // (0.6, 0, 1.8), normalised.
  const float n_h = 1.8f / std::sqrt(0.36f + 3.24f);
  const float lobe = 0.75f * std::pow(n_h, 20.0f);
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), lobe * Vec3f(0.5f, 0.25f, 1.0f), kRounding);
  std::get<PhongSurface>(s.scene.materials[0].surface).highlight_kind = Highlight::kPlastic;
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(lobe), kRounding);
}

TEST(Whitted, spheres_cast_shadows) {
  SmallScene s;
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  s.add(Spheres{{{1.0f, 0, 3.0f}, 0.3f}}, s.material(matte(Vec3f(1.0f))));
  s.point_light({2, 0, 6});
  const Picture p = trace(s.scene, single_view(kSize));
  expect_color(p.at(kMiddle, kMiddle), Vec3f(0.0f), 0.0f);
  EXPECT_GT(p.at(kMiddle - 8, kMiddle).x, 0.5f);
}

TEST(Whitted, transparent_blockers_attenuate_by_opacity) {
  for (const bool analytic : {true, false}) {
    SmallScene s;
    s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
    PhongSurface veil = matte(Vec3f(0.0f));
    veil.opacity = 0.25f;
    const int material = s.material(veil);
    if (analytic)
      s.add(Rings{{{0, 0, 12}, {0, 0, 1}, 0.0f, 1.0f}}, material);
    else
      // The square is moved so that the ray does not hit the diagonal, which two triangles share.
      s.add(square(1, 12), material, s.node({Mat3f(1.0f), {0.3f, 0, 0}}));
    s.point_light({0, 0, 20});
    expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(0.75f), kRounding);
  }
}

TEST(Whitted, rays_along_shared_edges_hit) {
  // The square is larger than the view, and its diagonal passes through the centres of pixels. The node's rotation
  // undoes the rotation of the mesh, so rounding moves points of the diagonal to both sides.
  constexpr int kPixels = 200;
  int holes = 0;
  for (int n = 1; n <= 100; ++n) {
    SmallScene s;
    const Mat3f turn = glm::mat3_cast(glm::angleAxis(0.37f * static_cast<float>(n), glm::normalize(Vec3f(0.3f, 0.4f, 0.8f))));
    Mesh mesh = square(2.5f, 0);
    // The shared edge is a different side of each triangle, so that the intersection tests of the triangles round
    // differently.
    mesh.triangles = {{3, 2, 0}, {2, 1, 0}};
    for (Vec3f& p : mesh.positions) p = glm::transpose(turn) * p;
    s.add(mesh, s.material(glowing(Vec3f(1.0f))), s.node({turn, Vec3f(0.0f)}));
    s.add(Shape(mesh), 0, s.node({turn, Vec3f(0.0f, 100.0f, 0.0f)}));  // meshes used twice become Embree instances
    const Picture p = trace(s.scene, single_view(kPixels));
    for (int i = 0; i < kPixels; ++i) holes += p.at(i, i).x != 1.0f;
  }
  EXPECT_EQ(holes, 0);
}

/// A right-angled triangle in the plane z = 0, lit perpendicularly. It covers the quarter x > 0, y > 0 of the view. If
/// `smooth`, it has vertex normals.
Picture picture_of_corner(const Affine3f& place, bool smooth, bool moving) {
  SmallScene s;
  Mesh corner;
  corner.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
  if (smooth) corner.normals.assign(3, Vec3f(0, 0, 1));
  corner.triangles = {{0, 1, 2}};
  const int parent = moving ? s.moving_node({0, 0, 0}, {0, 0, 1}) : -1;
  s.scene.nodes.push_back({"", parent, {}, place});
  s.add(corner, s.material(matte(Vec3f(0.5f))), static_cast<int>(s.scene.nodes.size()) - 1);
  s.point_light({0, 0, 1e4f});
  return trace(s.scene, single_view(kSize));
}

TEST(Whitted, mirrored_nodes_flip_meshes_but_not_light) {
  const Affine3f mirrored{Mat3f(Vec3f(-1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1)), Vec3f(0.0f)};
  for (const bool smooth : {false, true})
    for (const bool moving : {false, true}) {
      const Picture p = picture_of_corner(mirrored, smooth, moving);
      expect_color(p.at(kMiddle - 5, kMiddle - 5), Vec3f(0.5f), 1e-4f);
      expect_color(p.at(kMiddle + 5, kMiddle - 5), Vec3f(0.0f), 0.0f);
      EXPECT_GT(p.aovs[Aov::kNormal].pixel(kMiddle - 5, kMiddle - 5)[2], 0.999f);
    }
}

TEST(Whitted, node_scaled_to_nothing_shows_nothing) {
  for (const Vec3f scale : {Vec3f(0.0f), Vec3f(1, 1, 0), Vec3f(0, 1, 1)})
    for (const bool smooth : {false, true})
      for (const bool moving : {false, true}) {
        const Affine3f flat{Mat3f(Vec3f(scale.x, 0, 0), Vec3f(0, scale.y, 0), Vec3f(0, 0, scale.z)), Vec3f(0.0f)};
        const Picture p = picture_of_corner(flat, smooth, moving);
        for (const float value : p.film.data) ASSERT_TRUE(value == 0.0f || std::abs(value - 0.5f) < 1e-4f) << value;
      }
}

TEST(Whitted, analytic_shapes_scaled_to_nothing_show_nothing) {
  const Shape shapes[] = {Spheres{{Vec3f(0.0f), 1.0f}}, Boxes{{}}, Cylinders{{}}, Rings{{}}};
  for (const Shape& shape : shapes)
    for (const bool moving : {false, true}) {
      SmallScene s;
      s.add(shape, s.material(glowing(Vec3f(1.0f))),
            moving ? s.moving_node({0, 0, 0}, {0, 0, 1}) : s.node({Mat3f(0.0f), Vec3f(0.1f)}));
      if (moving) s.scene.timeline.animations[0].scale = {{0.0}, {Vec3f(0.0f)}};
      const Picture p = trace(s.scene, single_view(kSize));
      for (const float value : p.film.data) ASSERT_EQ(value, 0.0f) << shape.index();
    }
}

TEST(Whitted, nearly_flat_nodes_show_nothing) {
  SmallScene s;
  Mesh corner;
  corner.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
  corner.triangles = {{0, 1, 2}};
  const int moving = s.moving_node({0, 0, 0}, {0, 0, 1});
  const Affine3f squeezed{Mat3f(Vec3f(1e-30f, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1)), Vec3f(0.0f)};
  s.scene.nodes.push_back({"", moving, {}, squeezed});
  s.add(corner, s.material(glowing(Vec3f(1.0f))), static_cast<int>(s.scene.nodes.size()) - 1);
  s.add(Spheres{{Vec3f(0.0f), 0.1f}}, s.material(glowing(Vec3f(0.5f))));
  const Picture p = trace(s.scene, single_view(kSize));
  expect_color(p.at(kMiddle, kMiddle), Vec3f(0.5f), 0.0f);
  expect_color(p.at(kMiddle + 9, kMiddle - 9), Vec3f(0.0f), 0.0f);
}

TEST(Whitted, overflowing_rays_hit_nothing) {
  SmallScene s;
  s.add(Spheres{{Vec3f(0.0f), 1.0f}}, s.material(matte(Vec3f(0.5f))));
  s.point_light({1e30f, 0, 0});
  const Affine3f far_away{Mat3f(1.0f), Vec3f(1e30f, 0, 0)};
  s.add(Spheres{{Vec3f(0.0f), 1.0f}}, s.material(matte(Vec3f(0.5f))), s.node(far_away));
  for (const float scale : {1.0f, 1e19f, 1e30f}) {
    const Picture p = trace(s.scene, single_view(kSize), {}, 1, 0.0, {Mat3f(scale), Vec3f(0.0f)});
    for (const float value : p.film.data) ASSERT_TRUE(value >= 0.0f && value <= 0.5f) << value << " at " << scale;
  }
}

TEST(Whitted, tiny_facets_are_lit_like_large_ones) {
  for (const float size : {1.0f, 1e-9f}) {
    SmallScene s;
    Mesh corner;
    corner.positions = {{0, 0, 0}, {9 * size, 0, 0}, {0, 9 * size, 0}};
    corner.triangles = {{0, 1, 2}};
    s.add(corner, s.material(matte(Vec3f(0.5f))));
    s.point_light({0, 0, 1e4f});
    const Picture p = trace(s.scene, single_view(kSize), {}, 1, 0.0, {Mat3f(size), Vec3f(0.0f)});
    expect_color(p.at(kMiddle + 5, kMiddle - 5), Vec3f(0.5f), 1e-4f);
  }
}

TEST(Whitted, endless_splitting_names_max_depth) {
  SmallScene s;
  PhongSurface half_mirror;
  half_mirror.mirror = half_mirror.opacity = 0.5f;
  s.add(Spheres{{Vec3f(0.0f), 50.0f}}, s.material(half_mirror));
  s.add(Spheres{{Vec3f(0.0f), 60.0f}}, s.material(half_mirror));
  s.scene.max_depth = 1000;
  try {
    trace(s.scene, single_view(kSize));
    FAIL() << "2^1000 rays were traced";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("`max-depth`"), std::string::npos) << error.what();
  }
}

TEST(Whitted, mirrors_show_objects_behind_the_viewer) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.add(square(2, 0), s.material(mirror(0.5f)));
  s.add(square(30, 20), s.material(glowing({0.2f, 0.4f, 0.8f})));
  const Picture p = trace(s.scene, single_view(kSize));
  expect_color(p.at(kMiddle, kMiddle), 0.5f * Vec3f(0.2f, 0.4f, 0.8f), kRounding);
  EXPECT_EQ(p.counts.reflection, p.counts.primary);
}

TEST(Whitted, facing_mirrors_end_at_the_depth_limit) {
  // The vertices of a path alternate between the two mirrors, and each adds its emission of 1. At the depth limit, the
  // background is visible.
  SmallScene s;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(8.0f);
  PhongSurface surface = mirror(0.5f);
  surface.emission = Vec3f(1.0f);
  const int material = s.material(surface);
  s.add(square(50, 0), material);
  s.add(square(50, 12), material);
  for (int depth = 1; depth <= 4; ++depth) {
    s.scene.max_depth = depth;
    float expected = 0.0f, share = 1.0f;
    for (int vertex = 0; vertex < depth; ++vertex, share *= 0.5f) expected += share;
    expected += share * 8.0f;
    expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(expected), 1e-4f);
    s.scene.encoding = Encoding::kTachyonTruncate;  // Tachyon adds the background without the last mirror's share
    expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(expected + share * 8.0f), 1e-4f);
    s.scene.encoding = Encoding::kSrgb;
  }
}

TEST(Whitted, glass_slabs_shift_by_snells_law) {
  // A ray that enters a slab of thickness d at angle a and continues inside at angle b leaves it parallel, shifted
  // sideways by d sin(a - b) / cos b.
  SmallScene s;
  s.scene.max_depth = 3;
  PhongSurface glass = matte(Vec3f(0.0f));
  glass.opacity = 0.0f;
  glass.ior = 1.5f;
  s.add(Boxes{{{-20, -20, 0}, {20, 20, 4}}}, s.material(glass));
  Mesh ramp = square(20, -1);  // its colour encodes x: 0 at x = -20, 1 at x = 20
  Texture gradient;
  gradient.width = 256, gradient.height = 1;
  gradient.srgb = false;
  gradient.wrap_u = gradient.wrap_v = Wrap::kClamp;
  for (int x = 0; x < 256; ++x)
    for (int c = 0; c < 4; ++c) gradient.rgba.push_back(static_cast<std::uint8_t>(x));
  s.scene.textures.push_back(gradient);
  PhongSurface glow = glowing(Vec3f(1.0f));
  glow.texture = 0;
  s.add(ramp, s.material(glow));
  const Picture p = trace(s.scene, single_view(kSize));
  const float x0 = 4.0f * 16.0f / 33.0f;  // x at which the last pixel's ray meets z = 0
  const float slope = x0 / 10.0f;         // tangent of the ray's angle a to the slab's normal
  const float sine = slope / std::sqrt(1.0f + slope * slope), inside = std::tan(std::asin(sine / 1.5f));
  const float x = slope * (10.0f - 4.0f) + inside * 4.0f + slope * 1.0f;
  // The texture has a step of 40 / 256 per texel; the tolerance is below half a step.
  EXPECT_NEAR(p.at(kSize - 1, kMiddle).x * 40.0f * 255.0f / 256.0f - 20.0f + 20.0f / 256.0f, x, 0.03f);
}

TEST(Whitted, aovs_hold_depth_normal_object_and_position) {
  SmallScene s;
  const int material = s.material(matte(Vec3f(1.0f)));
  s.add(square(5, -1), material);
  const int ball = s.add(Spheres{{{0, 0, 1}, 0.5f}}, material);
  const Picture p = trace(s.scene, single_view(kSize));
  const std::size_t middle = kMiddle * kSize + kMiddle;
  EXPECT_NEAR(p.aovs[Aov::kDepth].data[middle], 1.5f, 1e-5f);
  EXPECT_EQ(p.aovs[Aov::kId].data[middle], static_cast<float>(ball));
  EXPECT_NEAR(p.aovs[Aov::kNormal].data[3 * middle + 2], 1.0f, 1e-6f);
  EXPECT_NEAR(p.aovs[Aov::kPosition].data[3 * middle + 2], 1.5f, 1e-5f);
  EXPECT_NEAR(p.aovs[Aov::kDepth].data[0], -1.0f, 1e-5f);
}

TEST(Whitted, back_side_is_shaded_like_the_front) {
  SmallScene s;
  const Affine3f turned{glm::mat3_cast(glm::angleAxis(kPi, Vec3f(0, 1, 0))), {}};
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))), s.node(turned));
  s.point_light({0, 0, 4});
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(1.0f), kRounding);
}

TEST(Whitted, visible_lights_are_balls_without_shadow) {
  SmallScene s;
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, 2}, {0.5f, 0.25f, 0.125f}).visible_radius = 0.3f;
  s.point_light({0, 0, 6});
  const Picture p = trace(s.scene, single_view(kSize));
  expect_color(p.at(kMiddle, kMiddle), {0.5f, 0.25f, 0.125f}, 0.0f);
  EXPECT_GT(p.at(kMiddle + 6, kMiddle).z, 0.8f) << "lit by the second light, past the first one's ball";
}

TEST(Whitted, infinite_planes_are_visible_and_cast_shadows) {
  SmallScene s;
  s.add(Planes{{{0, 0, -1}, {0, 0, 1}}}, s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, -3});
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(0.0f), 0.0f);
  s.point_light({0, 0, 3}, Vec3f(0.5f));
  expect_color(trace(s.scene, single_view(kSize)).at(kMiddle, kMiddle), Vec3f(0.5f), kRounding);
}

}  // namespace
}  // namespace lippmann

// The camera at (0, 0, 10) sees the square from -2 to 2 in x and y at z = 0. Its central rays run along -z.
#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kShadedSize = 33, kShadedMiddle = 16;

SmallScene tachyon_scene() {
  SmallScene s;
  s.scene.encoding = Encoding::kTachyonTruncate;
  return s;
}

Vec3f middle(const SmallScene& s) { return trace(s.scene, single_view(kShadedSize)).at(kShadedMiddle, kShadedMiddle); }

/// Shows only its highlight. With light and view at 45 degrees to each other, the cosine N.H between the normal and the
/// half vector is cos 22.5 degrees.
PhongSurface highlighted(Highlight kind) {
  PhongSurface surface = matte(Vec3f(1.0f, 0.5f, 0.25f));
  surface.diffuse = 0.0f;
  surface.highlight_kind = kind;
  surface.highlight = 0.5f;
  surface.highlight_size = 2.0f;
  return surface;
}
// Radiance of the highlight, 0.5 (N.H)^2, for a light at 45 degrees from the normal and a view along the normal.
const float kLobe = 0.5f * std::cos(kPi / 8) * std::cos(kPi / 8);

TEST(TachyonShading, metal_highlight_has_the_surfaces_colour) {
  SmallScene s = tachyon_scene();
  s.add(square(2, 0), s.material(highlighted(Highlight::kMetal)));
  s.point_light({5, 0, 5}, {0.1f, 0.2f, 0.3f});
  expect_color(middle(s), kLobe * Vec3f(1.0f, 0.5f, 0.25f));
}

TEST(TachyonShading, plastic_highlight_has_the_lights_colour) {
  SmallScene s = tachyon_scene();
  s.add(square(2, 0), s.material(highlighted(Highlight::kPlastic)));
  s.point_light({5, 0, 5}, {0.1f, 0.2f, 0.3f});
  expect_color(middle(s), kLobe * Vec3f(0.1f, 0.2f, 0.3f));
}

TEST(TachyonShading, highlight_ignores_shadows_and_attenuation) {
  SmallScene s = tachyon_scene();
  s.add(square(2, 0), s.material(highlighted(Highlight::kPlastic)));
  PhongSurface veil = matte(Vec3f(0.0f));
  veil.opacity = 0.9f;
  s.add(Rings{{{2.5f, 0, 2.5f}, glm::normalize(Vec3f(1, 0, 1)), 0.0f, 0.5f}}, s.material(veil));
  s.point_light({5, 0, 5}).attenuation = {0.0f, 1.0f, 0.0f};
  expect_color(middle(s), Vec3f(kLobe));
}

TEST(TachyonShading, light_fades_by_its_attenuation) {
  SmallScene s = tachyon_scene();
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, 4}).attenuation = {0.5f, 0.25f, 0.125f};
  expect_color(middle(s), Vec3f(1.0f / (0.5f + 1.0f + 2.0f)));
}

TEST(TachyonShading, light_below_a_512th_is_ignored) {
  SmallScene s = tachyon_scene();
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  Light& light = s.point_light({0, 0, 4}, Vec3f(1000.0f));
  light.attenuation = {505.0f, 0.0f, 0.0f};
  EXPECT_GT(middle(s).x, 1.9f);
  light.attenuation = {515.0f, 0.0f, 0.0f};
  expect_color(middle(s), Vec3f(0.0f), 0.0f);
}

/// The light is seen at 45 degrees, half-way between its cones of 30 and 60 degrees.
TEST(TachyonShading, spot_light_falls_off_linearly_with_the_angle) {
  SmallScene s = tachyon_scene();
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  Light& light = s.point_light({4, 0, 4});  // shines along -z; the centre is at 45 degrees from its axis
  light.kind = LightKind::kSpot;
  light.inner_cone = radians(30.0f), light.outer_cone = radians(60.0f);
  expect_color(middle(s), Vec3f(0.5f * std::sqrt(0.5f)));
  light.outer_cone = radians(44.9f);
  expect_color(middle(s), Vec3f(0.0f), 0.0f);
}

TEST(TachyonShading, transparent_surfaces_keep_their_own_light) {
  SmallScene s = tachyon_scene();
  s.scene.max_depth = 2;
  PhongSurface veil = glowing({0.5f, 0.25f, 0.0f});
  veil.opacity = 0.75f;
  s.add(square(2, 0), s.material(veil));
  s.add(square(2, -1), s.material(glowing(Vec3f(0.8f))));
  expect_color(middle(s), Vec3f(0.5f, 0.25f, 0.0f) + 0.25f * Vec3f(0.8f));
}

TEST(TachyonShading, last_transparent_surface_adds_the_background) {
  SmallScene s = tachyon_scene();
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(0.5f);
  PhongSurface veil = glowing(Vec3f(0.1f));
  veil.opacity = 0.75f;
  s.add(square(2, 0), s.material(veil));
  expect_color(middle(s), Vec3f(0.1f + 0.5f));
}

/// A shadow ray crosses sphere, box and cylinder twice. Each crossing transmits 1 - opacity.
TEST(SeeThrough, closed_shapes_attenuate_shadow_rays_twice) {
  PhongSurface veil = matte(Vec3f(0.0f));
  veil.opacity = 0.25f;
  for (const Shape& shape : {Shape(Spheres{{{0, 0, 12}, 1.0f}}), Shape(Boxes{{{-1, -1, 11.5f}, {1, 1, 12.5f}}}),
                             Shape(Cylinders{{{-2, 0, 12}, {2, 0, 12}, 0.5f}})}) {
    SmallScene s;
    s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
    s.add(shape, s.material(veil));
    s.point_light({0, 0, 20});
    expect_color(middle(s), Vec3f(0.75f * 0.75f));
  }
}

TEST(SeeThrough, light_inside_closed_shapes_is_attenuated_once) {
  PhongSurface veil = matte(Vec3f(0.0f));
  veil.opacity = 0.25f;
  SmallScene s;
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  s.add(Spheres{{{0, 0, 13}, 1.0f}}, s.material(veil));
  s.point_light({0, 0, 13});
  expect_color(middle(s), Vec3f(0.75f));
}

TEST(VertexColors, are_interpolated_and_multiply_the_materials) {
  SmallScene s;
  Mesh mesh = square(2, 0);
  mesh.colors = {{1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}};  // the middle is on the diagonal from corner 0 to corner 2
  s.add(mesh, s.material(glowing({0.5f, 0.5f, 1.0f})));
  expect_color(middle(s), {0.5f, 0.0f, 0.0f});
  const Picture p = trace(s.scene, single_view(kShadedSize));
  // The pixel is 8 pixels of 4/33 right of the middle. The square's side is 4, so the weights in triangle 0 2 1 change by this
  // distance / 4.
  const float moved = 8.0f * (4.0f / kShadedSize) / 4.0f;
  expect_color(p.at(kShadedMiddle + 8, kShadedMiddle), {0.5f * (1.0f - moved), 0.5f * moved, 0.0f});
}

TEST(Background, gradient_runs_between_its_two_heights) {
  SmallScene s;
  s.scene.background = {{1, 0, 0}, {0, 0, 1}, {0, 0, -1}, 0.5f, 1.5f};
  expect_color(middle(s), {0.5f, 0.0f, 0.5f});  // the ray runs along `up`, so its height is 1, half-way from 0.5 to 1.5
}

/// Far from the origin, rounding moves hit points by more than a small constant distance.
TEST(Secondary, surface_far_away_does_not_shade_itself) {
  SmallScene s = tachyon_scene();
  s.add(Spheres{{{0, 0, -20000}, 15000.0f}}, s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, 50000});
  const Picture p = trace(s.scene, single_view(kShadedSize));
  for (int y = 0; y < kShadedSize; ++y)
    for (int x = 0; x < kShadedSize; ++x) EXPECT_GT(p.at(x, y).x, 0.5f) << x << " " << y;
}

}  // namespace
}  // namespace lippmann

// Compares path-traced light with theory. The camera at (0, 0, 10) sees the square from -2 to 2 in x and y at z = 0.
// kNearby scales camera and square by 1/10.
#include <gtest/gtest.h>

#include <cmath>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

MetallicRoughness rough(Vec3f color, float metallic, float roughness) {
  MetallicRoughness m;
  m.base_color = Vec4f(color, 1.0f);
  m.metallic = metallic, m.roughness = roughness;
  return m;
}

Mesh room(float half) {
  Mesh m;
  for (int corner = 0; corner < 8; ++corner)
    m.positions.push_back({corner & 1 ? half : -half, corner & 2 ? half : -half, corner & 4 ? half : -half});
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}}};
  for (const auto& [a, b, c, d] : faces) {
    m.triangles.push_back({a, b, c});
    m.triangles.push_back({a, c, d});
  }
  return m;
}

TEST(PathTracer, white_spheres_vanish_in_a_white_furnace) {
  for (const float metallic : {0.0f, 1.0f})
    for (int r = 0; r <= 10; ++r) {
      SmallScene s;
      surround(s, Vec3f(1.0f));
      s.add(Spheres{{{0, 0, 0}, 3.0f}}, s.material(rough(Vec3f(1.0f), metallic, 0.1f * static_cast<float>(r))));
      // The tolerance covers the error of the tables of multiple scattering.
      EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 256).film), 1.0, 0.005)
          << "metallic " << metallic << ", roughness 0." << r;
    }
}

TEST(PathTracer, white_phong_and_glass_vanish) {
  MetallicRoughness glass = rough(Vec3f(1.0f), 0.0f, 0.0f);
  glass.transmission = 1.0f;
  PhongSurface pane = matte(Vec3f(1.0f));
  pane.opacity = 0.4f;
  for (int kind = 0; kind < 3; ++kind) {
    SmallScene s;
    s.scene.max_depth = 64;
    surround(s, Vec3f(1.0f));
    const int material = kind == 0 ? s.material(glass) : s.material(kind == 1 ? matte(Vec3f(1.0f)) : pane);
    s.add(Spheres{{{0, 0, 0}, 1.0f}, {{1, 0.5f, 2}, 0.5f}}, material);
    EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 256).film), 1.0, 0.005) << "kind " << kind;
  }
}

TEST(PathTracer, rough_glass_vanishes_in_a_white_furnace) {
  for (const float roughness : {0.3f, 0.7f, 1.0f}) {
    MetallicRoughness glass = rough(Vec3f(1.0f), 0.0f, roughness);
    glass.transmission = 1.0f;
    SmallScene s;
    s.scene.max_depth = 64;
    surround(s, Vec3f(1.0f));
    s.add(Spheres{{{0, 0, 0}, 3.0f}}, s.material(glass));
    // The tolerance covers the error of the tables of multiple scattering. Single scattering alone would lose 37 % at
    // roughness 0.7, and 66 % at roughness 1.
    EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 1024).film), 1.0, 0.01) << "roughness " << roughness;
  }
}

// A room with emission e and albedo a has the radiance L = e + a L. Paths of at most n vertices see the sum of e a^k for k = 0
// ... n, which is e (2 - 1/2^n) for a = 1/2.
TEST(PathTracer, glowing_rooms_follow_the_geometric_series) {
  for (const int depth : {1, 2, 8}) {
    SmallScene s;
    s.scene.max_depth = depth;
    PhongSurface wall = matte(Vec3f(0.5f));
    wall.emission = Vec3f(1.0f, 2.0f, 0.5f);
    s.add(room(20.0f), s.material(wall));
    const Picture p = trace_paths(s.scene, single_view(8), 256);
    const double series = 2.0 - std::pow(0.5, depth);
    EXPECT_NEAR(mean(p.film) / (3.5 / 3.0), series, 0.01 * series) << depth << " vertices";
  }
}

TEST(PathTracer, lambert_matches_whitted) {
  SmallScene s;
  s.add(square(2, 0), s.material(matte({0.5f, 0.25f, 1.0f})));
  s.point_light({3, 0, 4}, {1.0f, 0.5f, 0.25f});
  const Vec3f whitted = trace(s.scene, single_view(33)).at(16, 16), path = trace_paths(s.scene, single_view(33), 4).at(16, 16);
  // The tolerance covers the positions of the path tracer's samples, which are spread over the pixel.
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(path[c], whitted[c], 0.01f * whitted[c]);
}

TEST(PathTracer, a_metallic_roughness_surface_divides_by_pi) {
  SmallScene s;
  MetallicRoughness chalk = rough(Vec3f(0.5f), 0.0f, 1.0f);
  chalk.specular = 0.0f;
  s.add(square(2, 0), s.material(chalk));
  Light& light = s.point_light({0, 0, 4}, Vec3f(8.0f));
  light.inverse_square = true;
  EXPECT_NEAR(trace_paths(s.scene, single_view(33), 4).at(16, 16).x, 0.5f / kPi * 8.0f / 16.0f, 5e-4f);
}

/// Returns the form factor from a point to a parallel square of side 2 a, whose centre is at height h above the point.
/// It is four times the form factor of a square of side a with one corner above the point (Howell, configuration B-3).
double form_factor(double a, double h) {
  const double x = a / h, r = std::sqrt(1.0 + x * x);
  return 4.0 / M_PI * x / r * std::atan(x / r);
}

// Radiance of the floor: albedo x radiance of the lamp x form factor = 0.5 x 3 x 0.2399.
TEST(PathTracer, square_lights_match_their_form_factor) {
  PhongSurface lamp = matte(Vec3f(0.0f));
  lamp.emission = Vec3f(3.0f);
  for (const bool by_rays_alone : {false, true}) {
    SmallScene s;
    s.add(square(2, 0), s.material(matte(Vec3f(0.5f))));
    const int shines = s.material(lamp);
    if (by_rays_alone)  // paths hit boxes only by chance, while shadow rays sample meshes
      s.add(Boxes{{{-1, -1, 2}, {1, 1, 2.0001f}}}, shines);
    else
      s.add(square(1, 2), shines);
    const Picture p = trace_paths(s.scene, single_view(5), by_rays_alone ? 16'384 : 1024, {}, 1, kNearby);
    EXPECT_NEAR(p.at(2, 2).x, 0.5 * 3.0 * form_factor(1.0, 2.0), 0.01) << (by_rays_alone ? "by rays" : "aimed at");
  }
}

TEST(PathTracer, lamps_and_sky_add_up) {
  SmallScene s;
  surround(s, Vec3f(0.25f));
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, 5}, Vec3f(0.5f));
  s.point_light({0, 0, 7}, Vec3f(0.125f));
  EXPECT_NEAR(mean(trace_paths(s.scene, single_view(5), 2048, {}, 1, kNearby).film), 0.25 + 0.5 + 0.125, 0.005);
}

TEST(PathTracer, panorama_spots_act_as_distant_lamps) {
  SmallScene s;
  s.scene.background.map.emplace().radiance = Image(64, 32, 3);
  // One texel, in the direction +x and 30 degrees above the horizon, is bright. The square faces +x.
  const int row = 10;  // polar angles from 56.25 to 61.875 degrees
  std::fill_n(s.scene.background.map->radiance.pixel(32, row), 3, 1000.0f);
  const Mat3f towards_x(Vec3f(0, 0, -1), Vec3f(0, 1, 0), Vec3f(1, 0, 0));
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))), s.node({towards_x, Vec3f(0.0f)}));
  // Irradiance / pi of the texel: radiance x solid angle x cosine / pi. Bilinear interpolation spreads the texel over 2 x 2
  // texels with a mean weight of 1/4, which keeps its light.
  const double step = M_PI / 32, polar = (row + 0.5) * step, azimuth = 0.5 * step;
  const double cosine = std::sin(polar) * std::cos(azimuth), expected = 1000.0 * step * step * std::sin(polar) * cosine / M_PI;
  const Picture p = trace_paths(s.scene, single_view(5), 4096, {}, 1, {0.1f * towards_x, Vec3f(0.0f)});
  EXPECT_NEAR(p.at(2, 2).x, expected, 0.01 * expected);
}

// Radiance of the floor: 2 cos / pi from the sun, and 0.25 from the sky. The sun's texel may be 0.7 degrees from
// `toward`, which changes the cosine by 1 %.
TEST(PathTracer, suns_in_the_sky_give_their_irradiance) {
  SmallScene s;
  s.scene.max_depth = 3;
  const Vec3f toward = glm::normalize(Vec3f(-1.0f, 0.5f, 2.0f));
  s.scene.background.map = sunny_sky(Vec3f(0.25f), toward, Vec3f(2.0f));
  s.add(square(3, 0), s.material(matte(Vec3f(1.0f))));
  const double expected = 2.0 * static_cast<double>(toward.z) / M_PI + 0.25;
  EXPECT_NEAR(mean(trace_paths(s.scene, single_view(32), 256).film), expected, 0.01 * expected);
}

TEST(PathTracer, partial_coverage_passes_light_and_views) {
  SmallScene s;
  surround(s, Vec3f(1.0f));
  MetallicRoughness veil = rough(Vec3f(0.0f), 0.0f, 1.0f);
  veil.base_color.a = 0.25f, veil.blend = true, veil.specular = 0.0f;
  s.add(square(20, 1), s.material(veil));
  EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 256).film), 0.75, 0.005);
  s.scene.background = {};
  s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, 5}, Vec3f(1.0f));
  EXPECT_NEAR(trace_paths(s.scene, single_view(33), 1024).at(16, 16).x, 0.75f * 0.75f, 0.02f) << "down and up again";
}

TEST(PathTracer, cut_out_leaves_cast_shaped_shadows) {
  for (const bool by_paths : {false, true}) {
    SmallScene s;
    Texture texture;
    texture.width = 2, texture.height = 1;
    texture.wrap_u = texture.wrap_v = Wrap::kClamp;
    texture.rgba = {255, 255, 255, 0, 255, 255, 255, 255};
    s.scene.textures.push_back(texture);
    MetallicRoughness leaf = rough(Vec3f(1.0f), 0.0f, 1.0f);
    leaf.base_color_map.texture = 0;
    leaf.alpha_cutoff = 0.5f;
    s.add(square(1, 6), s.material(leaf));
    MetallicRoughness chalk = rough(Vec3f(1.0f), 0.0f, 1.0f);
    chalk.specular = 0.0f;
    s.add(square(2, 0), s.material(chalk));
    Light& light = s.point_light({0, 0, 0}, Vec3f(kPi));
    light.kind = LightKind::kDirectional;
    const Affine3f below{0.5f * Mat3f(1.0f), Vec3f(0.0f)};  // the eye at (0, 0, 5) sees the square from -1 to 1
    const Picture p =
        by_paths ? trace_paths(s.scene, single_view(9), 1, {}, 1, below) : trace(s.scene, single_view(9), {}, 1, 0.0, below);
    EXPECT_NEAR(p.at(1, 4).x, 1.0f, 0.02f) << by_paths;  // Whitted shading adds a weak highlight
    EXPECT_NEAR(p.at(7, 4).x, 0.0f, 1e-3f) << by_paths;
  }
}

TEST(PathTracer, light_through_a_clear_pane_counts_once) {
  PhongSurface pane = matte(Vec3f(0.0f));
  pane.opacity = 0.5f;
  SmallScene s;
  s.scene.max_depth = 4;
  surround(s, Vec3f(1.0f));
  s.add(square(200, 3), s.material(pane));
  s.add(square(20, 0), s.material(matte(Vec3f(0.8f))));
  // The camera is between pane and floor. Half of the sky's light passes the pane, and a little comes from the sides.
  EXPECT_NEAR(mean(trace_paths(s.scene, single_view(5), 1024, {}, 1, kNearby).film), 0.8 * 0.5, 0.008);
}

TEST(PathTracer, bulbs_are_seen_but_counted_once) {
  SmallScene s;
  s.add(square(20, 0), s.material(matte(Vec3f(1.0f))));
  s.point_light({0, 0, 2}, Vec3f(0.5f)).visible_radius = 0.3f;
  EXPECT_NEAR(trace_paths(s.scene, single_view(5), 512, {}, 1, kNearby).at(2, 2).x, 0.5, 0.005);
  EXPECT_NEAR(trace_paths(s.scene, single_view(33), 16).at(16, 16).x, 0.5, 1e-4) << "the bulb itself, from afar";
}

TEST(PathTracer, normal_maps_change_the_shading) {
  SmallScene s;
  Texture texture;
  texture.width = texture.height = 1;
  texture.srgb = false;
  texture.rgba = {255, 128, 128, 255};  // the normal (1, 0.004, 0.004), nearly along the tangent
  s.scene.textures.push_back(texture);
  MetallicRoughness chalk = rough(Vec3f(1.0f), 0.0f, 1.0f);
  chalk.specular = 0.0f;
  chalk.normal_map.texture = 0;
  s.add(square(2, 0), s.material(chalk));
  Light& light = s.point_light({0, 0, 0}, Vec3f(kPi));
  light.kind = LightKind::kDirectional;
  // The light comes from between +x and +z. u grows along +x.
  const float c = std::sqrt(0.5f);
  s.scene.nodes.back().matrix = Affine3f{Mat3f(Vec3f(c, 0, -c), Vec3f(0, 1, 0), Vec3f(c, 0, c)), Vec3f(0.0f)};
  const Vec3f normal = glm::normalize(Vec3f(1.0f, 1.0f / 255, 1.0f / 255));
  EXPECT_NEAR(trace_paths(s.scene, single_view(33), 1).at(16, 16).x, glm::dot(normal, Vec3f(c, 0, c)), 2e-3f);
}

TEST(PathTracer, threads_do_not_change_bits) {
  SmallScene s = busy_scene(3);
  surround(s, Vec3f(0.4f));
  const Image one = trace_paths(s.scene, lenticular_view(), 5).film,
              three = trace_paths(s.scene, lenticular_view(), 5, {}, 3).film;
  EXPECT_EQ(one.data, three.data);
}

TEST(PathTracer, noise_depends_on_frame_and_seed) {
  SmallScene s = busy_scene(3);
  surround(s, Vec3f(0.4f));
  TraceParams first, second, third;
  second.frame = 1, third.seed = 1;
  const Image a = trace_paths(s.scene, lenticular_view(), 2, first).film;
  EXPECT_EQ(a.data, trace_paths(s.scene, lenticular_view(), 2, first).film.data);
  EXPECT_NE(a.data, trace_paths(s.scene, lenticular_view(), 2, second).film.data);
  EXPECT_NE(a.data, trace_paths(s.scene, lenticular_view(), 2, third).film.data);
}

// Neighbouring pixels below a lens belong to neighbouring views, whose noise must be independent.
TEST(PathTracer, noise_of_neighbouring_views_is_uncorrelated) {
  SmallScene s;
  PhongSurface lamp = matte(Vec3f(0.0f));
  lamp.emission = Vec3f(3.0f);
  s.add(square(20, 0), s.material(matte(Vec3f(0.5f))));
  s.add(Boxes{{{-9, -9, 12}, {9, 9, 12.1f}}}, s.material(lamp));
  const Image film = trace_paths(s.scene, lenticular_view(), 1).film;
  const double m = mean(film);
  double variance = 0.0, covariance = 0.0;
  int pairs = 0;
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x + 1 < film.width; ++x, ++pairs) {
      const double a = static_cast<double>(*film.pixel(x, y)) - m, b = static_cast<double>(*film.pixel(x + 1, y)) - m;
      variance += a * a, covariance += a * b;
    }
  EXPECT_GT(variance, 0.0);
  EXPECT_LT(std::abs(covariance / variance), 4.0 / std::sqrt(pairs));  // four standard deviations for independent noise
}

TEST(PathTracer, clamping_dims_only_indirect_light) {
  SmallScene s;
  s.scene.max_depth = 3;
  PhongSurface wall = matte(Vec3f(0.5f));
  wall.emission = Vec3f(1.0f);
  s.add(room(20.0f), s.material(wall));
  TraceParams params;
  params.clamp_indirect = 0.05f;
  // The emission 1 and the direct light 0.5 are not clamped. All light after them is limited to 0.05 per contribution.
  const double clamped = mean(trace_paths(s.scene, single_view(5), 256, params).film);
  EXPECT_GT(clamped, 1.495);
  EXPECT_LT(clamped, 1.5 + 4 * 0.05 + 0.005);
}

}  // namespace
}  // namespace lippmann

// The eye at (0, 0, 1) sees the middle of a floor at z = 0. Walls of glass are above the eye.
#include <gtest/gtest.h>

#include <cmath>

#include "trace/small_scene.hpp"
#include "transport/thin_film.hpp"

namespace lippmann {
namespace {

using namespace test;

const Integrator kIntegrators[] = {Integrator::kWhitted, Integrator::kPath};
const Affine3f kCloseUp{Mat3f(0.1f), Vec3f(0.0f)};
// Transmittance of a thin wall with the index n = 1.5. At normal incidence: 1 - ((n - 1) / (n + 1))^2 = 0.96. At 60
// degrees, the Fresnel reflectances for s and p polarisation are 0.17657 and 0.00180, with the mean 0.0891866.
constexpr float kAtNormal = 0.96f, kAtSixty = 1.0f - 0.0891866f;
const Vec3f kGreenish(0.5f, 0.9f, 0.25f);

MetallicRoughness plaster() {
  MetallicRoughness m;
  m.metallic = 0.0f, m.roughness = 1.0f, m.specular = 0.0f;
  return m;
}

MetallicRoughness brushed_steel() {
  MetallicRoughness m;
  m.roughness = 0.35f;
  return m;
}

MetallicRoughness pane(Vec3f color = Vec3f(1.0f), float roughness = 0.0f) {
  MetallicRoughness m;
  m.base_color = Vec4f(color, 1.0f);
  m.metallic = 0.0f, m.roughness = roughness, m.transmission = 1.0f;
  m.extensions.emplace().volume = Volume{};
  return m;
}

MetallicRoughness tinted_foil(Vec3f color) {
  MetallicRoughness m = pane(color);
  m.ior = 1.0f, m.specular = 0.0f;
  return m;
}

SmallScene floor_scene(const MetallicRoughness& surface = plaster()) {
  SmallScene s;
  s.add(square(30, 0), s.material(surface));
  return s;
}

void point_lamp(SmallScene& s, Vec3f position) { s.point_light(position, Vec3f(20.0f)).inverse_square = true; }
const Vec3f kAbove(0.0f, 0.0f, 3.0f), kSlanted(3.0f * std::sqrt(3.0f), 0.0f, 3.0f);

Vec3f middle_of(const Scene& scene, Integrator integrator, int spp) {
  TraceParams params;
  params.spp = spp;
  return trace(scene, single_view(5), params, 1, 0.0, kCloseUp, integrator).at(2, 2);
}

Vec3f share_left(SmallScene s, Vec3f lamp, Integrator integrator, const std::vector<MetallicRoughness>& walls, int spp = 4) {
  point_lamp(s, lamp);
  const Vec3f free = middle_of(s.scene, integrator, spp);
  float z = 1.5f;
  for (const MetallicRoughness& wall : walls) s.add(square(20, z += 0.1f), s.material(wall));
  return middle_of(s.scene, integrator, spp) / free;
}

TEST(ThinWalls, dim_by_fresnel_and_tint) {
  for (const Integrator integrator : kIntegrators) {
    expect_color(share_left(floor_scene(), kAbove, integrator, {pane(kGreenish)}), kAtNormal * kGreenish, 1e-4f);
    expect_color(share_left(floor_scene(), kSlanted, integrator, {pane(kGreenish)}), kAtSixty * kGreenish, 1e-4f);
  }
}

TEST(ThinWalls, two_walls_dim_twice) {
  for (const Integrator integrator : kIntegrators)
    expect_color(share_left(floor_scene(), kSlanted, integrator, {pane(kGreenish), pane()}), kAtSixty * kAtSixty * kGreenish,
                 1e-4f);
}

TEST(ThinWalls, pass_only_the_glass_share) {
  MetallicRoughness half = pane();
  half.transmission = 0.5f;
  for (const Integrator integrator : kIntegrators)
    expect_color(share_left(floor_scene(), kAbove, integrator, {half}), Vec3f(0.5f * kAtNormal), 1e-4f);
  MetallicRoughness coated = pane();
  coated.clearcoat = 1.0f;
  expect_color(share_left(floor_scene(), kAbove, Integrator::kPath, {coated}), Vec3f(0.96f * kAtNormal), 1e-3f);
}

TEST(ThinWalls, combine_alpha_and_glass) {
  MetallicRoughness veil = pane(kGreenish);
  veil.base_color.a = 0.25f, veil.blend = true;
  for (const Integrator integrator : kIntegrators)
    expect_color(share_left(floor_scene(), kAbove, integrator, {veil}), Vec3f(0.75f) + 0.25f * kAtNormal * kGreenish, 1e-4f);
}

Texture stripes() {
  Texture t;
  t.width = 64, t.height = 1;
  constexpr std::uint8_t kColors[4][4] = {{255, 255, 255, 255}, {0, 0, 255, 255}, {255, 255, 255, 0}, {0, 0, 0, 255}};
  for (int x = 0; x < t.width; ++x) t.rgba.insert(t.rgba.end(), kColors[x / 16], kColors[x / 16] + 4);
  t.srgb = false;
  return t;
}

std::vector<Vec3f> below_stripes(const MetallicRoughness& wall, Integrator integrator) {
  SmallScene s = floor_scene();
  s.scene.textures.push_back(stripes());
  Light& sun = s.point_light(Vec3f(0.0f), Vec3f(1.0f));
  sun.kind = LightKind::kDirectional;
  TraceParams params;
  params.spp = 16;
  const Picture free = trace(s.scene, single_view(4), params, 1, 0.0, {}, integrator);
  s.add(square(2, 11), s.material(wall));
  const Picture below = trace(s.scene, single_view(4), params, 1, 0.0, {}, integrator);
  std::vector<Vec3f> shares;
  for (int x = 0; x < 4; ++x) shares.push_back(below.at(x, 1) / free.at(x, 1));
  return shares;
}

// The tolerances cover texels at the ends of stripes, which mix with their neighbours.
TEST(ThinWalls, colours_come_from_their_textures) {
  MetallicRoughness wall = pane();
  wall.base_color_map.texture = 0;
  for (const Integrator integrator : kIntegrators) {
    const std::vector<Vec3f> shares = below_stripes(wall, integrator);
    expect_color(shares[0], Vec3f(kAtNormal), 0.03f);
    expect_color(shares[1], kAtNormal * Vec3f(0, 0, 1), 0.03f);
    expect_color(shares[3], Vec3f(0.0f), 0.03f);
  }
}

TEST(ThinWalls, are_open_where_masked) {
  MetallicRoughness wall = tinted_foil(Vec3f(0.5f));
  wall.base_color_map.texture = 0, wall.alpha_cutoff = 0.5f;
  for (const Integrator integrator : kIntegrators) {
    const std::vector<Vec3f> shares = below_stripes(wall, integrator);
    expect_color(shares[0], Vec3f(0.5f), 0.03f);
    expect_color(shares[2], Vec3f(1.0f), 0.03f);
  }
}

TEST(ThinWalls, transmission_comes_from_its_texture_for_paths) {
  MetallicRoughness wall = pane();
  wall.transmission_map.texture = 0;  // the red channel is 1, 0, 1, 0 from left to right
  const std::vector<Vec3f> shares = below_stripes(wall, Integrator::kPath);
  expect_color(shares[0], Vec3f(kAtNormal), 0.03f);
  expect_color(shares[1], Vec3f(0.0f), 0.03f);
}

TEST(ThinWalls, films_pass_the_remaining_light) {
  MetallicRoughness film = pane();
  film.extensions->iridescence.share = 1.0f;
  const Vec3f share = share_left(floor_scene(), kAbove, Integrator::kPath, {film});
  const Vec3f mirrored = film_reflectance({1.3f, 400.0f}, Vec3f(0.04f), 1.0f);
  expect_color(share, Vec3f(1.0f - std::max({mirrored.x, mirrored.y, mirrored.z})), 1e-3f);
}

// A rough wall scatters light, so shadow rays end at the wall. Paths of two vertices find the light.
TEST(ThinWalls, rough_walls_stop_shadow_rays) {
  expect_color(share_left(floor_scene(), kAbove, Integrator::kPath, {pane(Vec3f(1.0f), 0.03f)}), Vec3f(kAtNormal), 1e-4f);
  EXPECT_EQ(share_left(floor_scene(), kAbove, Integrator::kPath, {pane(Vec3f(1.0f), 0.04f)}).x, 0.0f);
  SmallScene deep = floor_scene();
  deep.scene.max_depth = 2;
  EXPECT_NEAR(share_left(deep, kAbove, Integrator::kPath, {pane(Vec3f(1.0f), 0.5f)}, 4096).x, kAtNormal, 0.3f);
}

TEST(ThinWalls, scattering_walls_stay_opaque) {
  MetallicRoughness leaf = plaster();
  leaf.extensions.emplace().volume = Volume{};
  leaf.extensions->diffuse_transmission.share = 1.0f;
  EXPECT_EQ(share_left(floor_scene(), kAbove, Integrator::kPath, {leaf}).x, 0.0f);
}

// The wall is an Embree instance, rotated and scaled by different factors.
TEST(ThinWalls, moving_walls_use_world_angles) {
  SmallScene s = floor_scene();
  point_lamp(s, kAbove);
  const Vec3f free[] = {middle_of(s.scene, Integrator::kWhitted, 4), middle_of(s.scene, Integrator::kPath, 4)};
  const int moving = s.moving_node({0, 0, 1.5f}, {0, 0, 1.6f});
  s.scene.nodes.back().local.translation = {0, 0, 1.5f};
  s.scene.nodes.back().local.rotation = glm::angleAxis(radians(60.0f), Vec3f(0, 1, 0));
  s.scene.nodes.back().local.scale = {3.0f, 5.0f, 0.25f};
  s.add(square(1, 0), s.material(pane(kGreenish)), moving);
  for (const int i : {0, 1})  // samples are spread around the pixel's centre
    expect_color(middle_of(s.scene, kIntegrators[i], 4) / free[i], kAtSixty * kGreenish, 5e-4f);
}

TEST(ThinWalls, vanish_in_a_white_furnace) {
  for (const float roughness : {0.0f, 0.3f}) {
    SmallScene s;
    s.scene.max_depth = 3;
    surround(s, Vec3f(1.0f));
    for (const float z : {0.0f, -1.0f, -2.0f}) s.add(square(40, z), s.material(pane(Vec3f(1.0f), roughness)));
    s.add(square(40, -3), s.material(plaster()));
    s.scene.max_depth = roughness > 0.0f ? 64 : 12;
    EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 512).film), 1.0, 0.01) << roughness;
  }
}

// Straight transmission is no path vertex: even behind more panes than the maximum number of vertices, the floor is
// visible.
TEST(ThinWalls, are_not_path_vertices) {
  SmallScene s = floor_scene();
  s.scene.max_depth = 1;
  point_lamp(s, {0, 0, 20});
  const Vec3f free = middle_of(s.scene, Integrator::kPath, 1);
  for (int wall = 0; wall < 4; ++wall) s.add(square(20, 0.1f + 0.1f * static_cast<float>(wall)), s.material(pane()));
  const float once = std::pow(kAtNormal, 4.0f);
  expect_color(middle_of(s.scene, Integrator::kPath, 16384) / free, Vec3f(once * once), 0.02f);
}

float left_below_foil(const SmallScene& lit, int spp) {
  SmallScene s = lit;
  const float free = middle_of(s.scene, Integrator::kPath, spp).x;
  s.add(square(30, 1.2f), s.material(tinted_foil(Vec3f(0.5f))));
  return middle_of(s.scene, Integrator::kPath, spp).x / free;
}

// Both shadow rays and scattered rays find each light. Also behind a wall, the weights of both rays must add up to one.
TEST(ThinWalls, split_light_between_rays_without_loss) {
  for (const MetallicRoughness& surface : {plaster(), brushed_steel()}) {
    SmallScene ball = floor_scene(surface), sun = ball, lamp = ball, sky = ball;
    point_lamp(ball, kAbove);
    ball.scene.lights.back().radius = 1.2f;
    EXPECT_NEAR(left_below_foil(ball, 8192), 0.5f, 0.01f) << "ball";
    sun.point_light(Vec3f(0.0f), Vec3f(2.0f)).kind = LightKind::kDirectional;
    sun.scene.lights.back().angular_diameter = radians(50.0f);
    EXPECT_NEAR(left_below_foil(sun, 8192), 0.5f, 0.01f) << "sun";
    lamp.add(square(1, 3), lamp.material(glowing(Vec3f(5.0f))));
    EXPECT_NEAR(left_below_foil(lamp, 8192), 0.5f, 0.01f) << "lamp";
    sky.scene.background.map = sunny_sky(Vec3f(0.5f), {0.1f, 0.1f, 1.0f}, Vec3f(1.0f));
    EXPECT_NEAR(left_below_foil(sky, 8192), 0.5f, 0.01f) << "sky";
  }
}

/// The lamp from -1 to 1 at z = 3 is a mesh, which shadow rays sample, or a box, which paths hit only by chance.
Scene lit_through_a_wall(const MetallicRoughness& surface, const MetallicRoughness& wall, bool by_chance, int depth) {
  SmallScene s = floor_scene(surface);
  s.scene.max_depth = depth;
  const int light = s.material(glowing(Vec3f(4.0f)));
  if (by_chance)
    s.add(Boxes{{{-1.0f, -1.0f, 3.0f}, {1.0f, 1.0f, 3.0001f}}}, light);
  else
    s.add(square(1, 3), light);
  Mesh bent = square(12, 1.5f);
  for (const float x : {-0.4f, 0.4f}) bent.normals.push_back(glm::normalize(Vec3f(x, 0.2f, 1.0f)));
  bent.normals.push_back(bent.normals[1]), bent.normals.push_back(bent.normals[0]);
  s.add(bent, s.material(wall));
  return s.scene;
}

struct Estimate {
  double mean, variance;
};
Estimate estimate(const Scene& scene) {
  constexpr int kSeeds = 12;
  double sum = 0.0, squares = 0.0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    TraceParams params;
    params.seed = seed;
    const double value = mean(trace_paths(scene, single_view(6), 256, params, 1, kCloseUp).film);
    sum += value, squares += value * value;
  }
  const double of_mean = sum / kSeeds;
  return {of_mean, (squares / kSeeds - of_mean * of_mean) / (kSeeds - 1)};
}

// The limit is 4.5 standard errors. With 11 degrees of freedom, one of 1,000 comparisons of equal pictures exceeds this
// limit. The seeds are fixed.
TEST(ThinWalls, light_matches_random_paths) {
  MetallicRoughness plain = pane(kGreenish), layered = pane(kGreenish);
  layered.clearcoat = 0.8f, layered.clearcoat_roughness = 0.3f, layered.transmission = 0.7f;
  layered.extensions->iridescence.share = 0.6f;
  layered.extensions->sheen.color = Vec3f(0.3f);
  for (const MetallicRoughness& surface : {plaster(), brushed_steel()})
    for (const MetallicRoughness& wall : {plain, layered})
      for (const int depth : {1, 5}) {
        const Estimate aimed = estimate(lit_through_a_wall(surface, wall, false, depth)),
                       chance = estimate(lit_through_a_wall(surface, wall, true, depth));
        EXPECT_LT(std::abs(aimed.mean - chance.mean), 4.5 * std::sqrt(aimed.variance + chance.variance))
            << aimed.mean << " " << chance.mean << " depth " << depth;
        EXPECT_GT(aimed.mean, 0.05);
      }
}

TEST(ThinWalls, show_the_visible_background) {
  SmallScene s;
  surround(s, Vec3f(0.5f));
  s.add(square(20, 0), s.material(tinted_foil(Vec3f(0.5f))));
  const ThreadPool pool(1);
  for (const Integrator integrator : kIntegrators) {
    s.scene.max_depth = 2;
    const DeviceScene device(s.scene, pool, integrator);
    TraceParams params;
    params.max_depth = 2, params.spp = 4;
    Picture p;
    p.aovs.want(Aov::kAlpha);
    trace_frame({device, single_view(4), {}}, params, {pool, Context{}}, {p.film, &p.aovs});
    EXPECT_EQ(p.aovs[Aov::kAlpha].pixel(1, 1)[0], 1.0f);
    EXPECT_NEAR(p.at(1, 1).x, 0.25f, 1e-5f);
  }
}

TEST(ThinWalls, transmitted_direct_light_stays_direct) {
  SmallScene s = floor_scene();
  s.scene.max_depth = 1;
  s.add(square(1, 3), s.material(glowing(Vec3f(4.0f))));
  for (const float z : {0.5f, 1.5f}) s.add(square(20, z), s.material(tinted_foil(Vec3f(0.5f))));
  const Picture p = trace_paths(s.scene, single_view(4), 64, {}, 1, kCloseUp);
  EXPECT_GT(mean(p.film), 0.05);
  EXPECT_EQ(mean(p.aovs[Aov::kIndirect]), 0.0);
}

TEST(ThinWalls, threads_do_not_change_bits) {
  const Scene scene = lit_through_a_wall(brushed_steel(), pane(kGreenish), false, 5);
  EXPECT_EQ(trace_paths(scene, single_view(32), 16, {}, 1, kCloseUp).film.data,
            trace_paths(scene, single_view(32), 16, {}, 3, kCloseUp).film.data);
}

}  // namespace
}  // namespace lippmann

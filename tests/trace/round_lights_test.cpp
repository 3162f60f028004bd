// Compares lamps that have a size with the geometry of their light and shadows. The camera at (0, 0, 10) sees the
// square from -2 to 2 in x and y at z = 0. kNearby scales camera and square by 1/10.
#include "shading/round_lights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

MetallicRoughness chalk() {
  MetallicRoughness m;
  m.metallic = 0.0f, m.roughness = 1.0f, m.specular = 0.0f;
  return m;
}

MetallicRoughness metal(float roughness) {
  MetallicRoughness m;
  m.roughness = roughness;
  return m;
}

Light& ball(SmallScene& s, Vec3f position, float intensity, float radius) {
  Light& light = s.point_light(position, Vec3f(intensity));
  light.inverse_square = true;
  light.radius = radius;
  return light;
}

Light& sun(SmallScene& s, Vec3f toward, float illuminance, float angular_diameter) {
  Light& light = s.point_light(Vec3f(0.0f), Vec3f(illuminance));
  const Vec3f z = glm::normalize(toward), x = glm::normalize(glm::cross(Vec3f(0, 1, 0), z));
  s.scene.nodes.back().matrix = Affine3f{Mat3f(x, glm::cross(z, x), z), Vec3f(0.0f)};
  light.kind = LightKind::kDirectional;
  light.angular_diameter = angular_diameter;
  return light;
}

float irradiance(SmallScene s, int spp = 256) {
  s.add(square(2, 0), s.material(chalk()));
  return kPi * trace_paths(s.scene, single_view(5), spp, {}, 1, kNearby).at(2, 2).x;
}

// A sphere above the horizon gives the light of a point lamp at its centre: intensity x cosine / distance^2.
TEST(RoundLight, spheres_give_the_irradiance_of_points) {
  for (const float radius : {0.1f, 1.0f, 3.5f}) {
    SmallScene s;
    ball(s, {0, 0, 4}, 8.0f, radius);
    EXPECT_NEAR(irradiance(s), 8.0f / 16.0f, 0.005f) << radius;
  }
  SmallScene s;
  ball(s, {3, 0, 4}, 50.0f, 1.5f);
  EXPECT_NEAR(irradiance(s), 50.0f / 25.0f * 0.8f, 0.02f) << "from the side";
}

TEST(RoundLight, spheres_light_their_inside_uniformly) {
  SmallScene s;
  ball(s, {0, 0, 4}, 50.0f, 5.0f);
  EXPECT_NEAR(irradiance(s), 50.0f / 25.0f, 0.01f);
}

// The sphere's centre is on the horizon. With s = radius / distance, the irradiance is (intensity / (pi radius^2)) (asin s - s
// sqrt(1 - s^2)).
TEST(RoundLight, half_of_spheres_on_the_horizon_counts) {
  SmallScene s;
  ball(s, {4, 0, 0}, 8.0f, 2.0f);
  const double sine = 0.5, expected = 8.0 / (M_PI * 4.0) * (std::asin(sine) - sine * std::sqrt(1.0 - sine * sine));
  EXPECT_NEAR(irradiance(s, 1024), expected, 0.02 * expected);
}

TEST(RoundLight, suns_give_illuminance_times_cosine) {
  for (const float degrees : {0.5f, 10.0f, 60.0f}) {
    SmallScene upright, inclined;
    sun(upright, {0, 0, 1}, 3.0f, radians(degrees));
    sun(inclined, {1, 0, 1}, 3.0f, radians(degrees));
    EXPECT_NEAR(irradiance(upright), 3.0f, 0.02f) << degrees;
    EXPECT_NEAR(irradiance(inclined, 1024), 3.0f * std::sqrt(0.5f), 0.02f) << degrees;
  }
}

/// Returns the fraction of a lamp's light that passes an edge at (x, z) = (0, 2) and reaches the white floor at z = 0.
/// Pixel i of 64 is at x = -1 + (i + 0.5) / 16.
std::vector<float> past_an_edge(const SmallScene& lit) {
  constexpr int kPixels = 64;
  const Affine3f view{Mat3f(1.0f), {1.0f, 0.0f, 0.0f}};
  std::vector<float> rows[2];
  for (const bool shaded : {false, true}) {
    SmallScene s = lit;
    const int floor = s.material(chalk());
    s.add(square(8, 0), floor);
    Mesh edge = square(4, 2);
    for (Vec3f& p : edge.positions) p.x -= 4.0f;
    if (shaded) s.add(edge, floor);
    const Picture p = trace_paths(s.scene, single_view(kPixels), 256, {}, 1, view);
    for (int x = 0; x < kPixels; ++x) rows[shaded].push_back(p.at(x, kPixels / 2).x);
  }
  for (std::size_t x = 0; x < rows[0].size(); ++x) rows[1][x] /= rows[0][x];
  return rows[1];
}
int pixel_at(double x) { return static_cast<int>((x + 1.0) * 16.0); }

// From the edge at (0, 0, 2), the lamp's centre is at 45 degrees from the vertical, at a distance of sqrt(8), and its sides at
// 45 degrees +- asin(0.5 / sqrt(8)) = 45 +- 10.2 degrees. The floor is 2 below, so the penumbra extends from x = 2 tan(34.8
// deg) = 1.391 to 2 tan(55.2 deg) = 2.876.
TEST(RoundLight, sphere_penumbra_matches_its_tangents) {
  SmallScene s;
  ball(s, {-2, 0, 4}, 100.0f, 0.5f);
  const std::vector<float> light = past_an_edge(s);
  EXPECT_EQ(light[pixel_at(1.391) - 1], 0.0f);
  EXPECT_GT(light[pixel_at(1.391) + 2], 0.0f);
  EXPECT_NEAR(0.5f * (light[pixel_at(2.0) - 1] + light[pixel_at(2.0)]), 0.5f, 0.03f);
  EXPECT_LT(light[pixel_at(2.876) - 3], 0.999f);
  EXPECT_NEAR(light[pixel_at(2.876) + 1], 1.0f, 1e-5f);
}

// From the edge, the sun's disc is at 45 +- 5 degrees from the vertical. The floor is 2 below, so the penumbra extends from x =
// 2 tan(40 deg) = 1.678 to 2 tan(50 deg) = 2.384.
TEST(RoundLight, sun_penumbra_matches_its_disc) {
  SmallScene s;
  sun(s, {-1, 0, 1}, 1.0f, radians(10.0f));
  const std::vector<float> light = past_an_edge(s);
  EXPECT_EQ(light[pixel_at(1.678) - 1], 0.0f);
  EXPECT_GT(light[pixel_at(1.678) + 2], 0.0f);
  EXPECT_NEAR(0.5f * (light[pixel_at(2.0) - 1] + light[pixel_at(2.0)]), 0.5f, 0.03f);
  EXPECT_LT(light[pixel_at(2.384) - 2], 0.999f);
  EXPECT_NEAR(light[pixel_at(2.384) + 1], 1.0f, 1e-5f);
}

// The lamp is compared with a glowing sphere of the same size, which paths find only by chance.
TEST(RoundLight, lamps_are_counted_once) {
  constexpr float kRadius = 0.8f, kIntensity = 4.0f;
  const Vec3f at{0.3f, 0.2f, 2.5f};
  for (const MetallicRoughness& floor : {chalk(), metal(0.5f), metal(0.2f), metal(0.0f)}) {
    SmallScene lamp, shape;
    ball(lamp, at, kIntensity, kRadius);
    PhongSurface shines = matte(Vec3f(0.0f));
    // In scenes with Phong surfaces, lamps are pi times as bright, but glowing shapes are not.
    shines.emission = Vec3f(kIntensity / (kPi * kRadius * kRadius));
    shape.add(Spheres{{at, kRadius}}, shape.material(shines));
    double light[2];
    for (SmallScene* s : {&lamp, &shape}) {
      s->add(square(2, 0), s->material(floor));
      light[s == &shape] = mean(trace_paths(s->scene, single_view(8), 4096, {}, 1, kNearby).film);
    }
    EXPECT_NEAR(light[0], light[1], 0.015 * light[1]) << "metallic " << floor.metallic << ", roughness " << floor.roughness;
    EXPECT_GT(light[1], 0.01);
  }
}

TEST(RoundLight, only_mirrors_show_lamps) {
  SmallScene s;
  s.add(square(2, 0), s.material(metal(0.0f)));
  Light& light = ball(s, {0, 0, 3}, 2.0f, 0.5f);
  const float radiance = 2.0f / (kPi * 0.25f);
  EXPECT_NEAR(trace_paths(s.scene, single_view(5), 4, {}, 1, kNearby).at(2, 2).x, radiance, 0.01f * radiance);
  light.range = 2.0f;
  EXPECT_EQ(trace_paths(s.scene, single_view(5), 4, {}, 1, kNearby).at(2, 2).x, 0.0f) << "out of its range";
  SmallScene black;
  MetallicRoughness soot = chalk();
  soot.base_color = Vec4f(0, 0, 0, 1);
  black.add(square(2, 0), black.material(soot));
  ball(black, {0, 0, 3}, 2.0f, 0.5f);
  EXPECT_EQ(mean(trace_paths(black.scene, single_view(5), 4).film), 0.0) << "the lamp is between the eye and the floor";
}

TEST(RoundLight, lamps_do_not_occlude) {
  SmallScene s;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(1.0f);
  ball(s, {0, 0, 2}, 1e-6f, 1.5f);
  EXPECT_NEAR(irradiance(s, 4096), kPi, 0.01f);
}

// The outer and inner cones have the cosines 0.5 and 1, and the direction to the point 0.75, half-way (t = 1/2). The
// squared edge is t^2 = 1/4, the smooth edge 3 t^2 - 2 t^3 = 1/2.
TEST(RoundLight, spot_edges_are_smooth_or_squared) {
  for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
    for (const bool smooth : {false, true}) {
      SmallScene s;
      s.add(square(2, 0), s.material(matte(Vec3f(1.0f))));
      const float tangent = std::sqrt(1.0f - 0.75f * 0.75f) / 0.75f;
      Light& light = s.point_light({tangent, 0, 1}, Vec3f(1.0f));
      light.kind = LightKind::kSpot;
      light.outer_cone = kPi / 3;
      light.smooth_edge = smooth;
      const float expected = 0.75f * (smooth ? 0.5f : 0.25f);
      const Picture p = trace(s.scene, single_view(33), {}, 1, 0.0, kNearby, integrator);
      EXPECT_NEAR(p.at(16, 16).x, expected, 0.005f) << integrator.facts().name << smooth;
    }
  }
}

TEST(RoundLight, negligible_sizes_equal_points) {
  const auto film = [](float radius, float angle) {
    SmallScene s = busy_scene(3);
    ball(s, {-3, 4, 8}, 50.0f, radius);
    sun(s, {1, 2, 3}, 0.5f, angle);
    return trace_paths(s.scene, single_view(32), 4).film.data;
  };
  EXPECT_EQ(film(1e-6f, 1e-6f), film(0.0f, 0.0f));
  EXPECT_NE(film(0.5f, 0.0f), film(0.0f, 0.0f));
  EXPECT_NE(film(0.0f, 0.1f), film(0.0f, 0.0f));
}

TEST(RoundLight, small_lamps_converge_to_points) {
  const auto light = [](float radius) {
    SmallScene s = busy_scene(5);
    ball(s, {-3, 4, 8}, 50.0f, radius);
    return mean(trace_paths(s.scene, single_view(32), 16).film);
  };
  EXPECT_NEAR(light(0.01f), light(0.0f), 2e-3 * light(0.0f));
}

TEST(RoundLight, whitted_treats_lamps_as_points) {
  const auto film = [](float radius, float angle) {
    SmallScene s = busy_scene(3);
    ball(s, {-3, 4, 8}, 50.0f, radius);
    sun(s, {1, 2, 3}, 0.5f, angle);
    return trace(s.scene, single_view(32)).film.data;
  };
  EXPECT_EQ(film(0.5f, 0.2f), film(0.0f, 0.0f));
}

TEST(RoundLight, phong_highlights_show_lamps) {
  PhongSurface shiny = matte(Vec3f(0.0f));
  shiny.highlight_kind = Highlight::kPlastic, shiny.highlight = 1.0f, shiny.highlight_size = 4.0f;
  const auto light = [&](float radius) {
    SmallScene s;
    s.add(square(2, 0), s.material(shiny));
    ball(s, {0, 0, 4}, 8.0f, radius);
    return mean(trace_paths(s.scene, single_view(5), 64, {}, 1, kNearby).film);
  };
  EXPECT_GT(light(0.0f), 0.1);
  EXPECT_NEAR(light(0.2f), light(0.0f), 0.01 * light(0.0f));
}

// Directions are uniform in the cone, so 1 / density is its solid angle, 2 pi (1 - cos). Here sin = radius / distance = 1/2, so
// cos = sqrt(3/4).
TEST(RoundLight, directions_cover_the_cone_uniformly) {
  WhittedLight light;
  light.position = {1, 2, 3};
  light.falls_off = 1.0f;
  light.radius = 2.0f;
  const Vec3f from{1, 2, -1};
  Vec3f sum(0.0f);
  constexpr int kSteps = 64;
  for (int y = 0; y < kSteps; ++y)
    for (int x = 0; x < kSteps; ++x) {
      const Vec2f u{(static_cast<float>(x) + 0.5f) / kSteps, (static_cast<float>(y) + 0.5f) / kSteps};
      const auto drawn = sample_round(light, 1.0f, from, u);
      ASSERT_TRUE(drawn);
      EXPECT_NEAR(1.0f / drawn->density, 2.0f * kPi * (1.0f - std::sqrt(0.75f)), 1e-5f);
      const auto seen = see_round(light, 1.0f, from, drawn->direction);
      ASSERT_TRUE(seen);
      EXPECT_EQ(seen->density, drawn->density);
      EXPECT_EQ(seen->radiance, drawn->radiance);
      EXPECT_NEAR(glm::length(from + drawn->distance * drawn->direction - light.position), 2.0f, 1e-4f) << "on the sphere";
      sum += drawn->direction;
    }
  // the mean of uniform directions in a cone is (1 + cos) / 2 along its axis
  EXPECT_NEAR(sum.z / (kSteps * kSteps), 0.5f * (1.0f + std::sqrt(0.75f)), 1e-4f);
  EXPECT_NEAR(sum.x / (kSteps * kSteps), 0.0f, 1e-4f);
  // 31 degrees from the axis, outside the lamp's cone of 30 degrees
  EXPECT_FALSE(see_round(light, 1.0f, from, glm::normalize(Vec3f(0.6f, 0.0f, 1.0f))));
  EXPECT_FALSE(see_round(light, 1.0f, from, Vec3f(0, 0, -1)));
}

}  // namespace
}  // namespace lippmann

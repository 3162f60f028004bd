#include "transport/environment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "chi_squared.hpp"
#include "transport/sampler.hpp"
#include "transport/sampling.hpp"

namespace lippmann {
namespace {

Background panorama(int width, int height, const std::function<Vec3f(int, int)>& color) {
  Background b;
  b.map.emplace().radiance = Image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec3f c = color(x, y);
      std::copy(&c.x, &c.x + 3, b.map->radiance.pixel(x, y));
    }
  return b;
}

Environment::Density density_of(const Environment& e, Vec3f direction) {
  SkyRays rays;
  std::fill_n(rays.x, SkyRays::kRays, direction.x);
  std::fill_n(rays.y, SkyRays::kRays, direction.y);
  std::fill_n(rays.z, SkyRays::kRays, direction.z);
  e.radiance(rays);
  return e.density(rays, 0);
}

// The panorama has eight columns of 45 degrees. Column 4 begins at +x, and column 6 at +z.
TEST(Environment, a_panorama_lies_as_documented) {
  Background b = panorama(8, 4, [](int x, int y) { return Vec3f(static_cast<float>(x), static_cast<float>(y), 1.0f); });
  const Environment e(b);
  const float turn = radians(22.5f);
  const Vec3f x_axis = e.radiance({std::cos(turn) * std::cos(turn), std::sin(turn), std::sin(turn) * std::cos(turn)});
  EXPECT_NEAR(x_axis.x, 4.0f, 1e-4f);
  EXPECT_NEAR(x_axis.y, 1.0f, 1e-4f);  // the centre of row 1 is 22.5 degrees above the horizon
  const float quarter = radians(112.5f);
  EXPECT_NEAR(e.radiance({std::cos(quarter), 0.0f, std::sin(quarter)}).x, 6.0f, 1e-4f);  // column 6 begins at +z
  EXPECT_NEAR(e.radiance({0.0f, 1.0f, 0.0f}).y, 0.0f, 1e-4f);
  EXPECT_NEAR(e.radiance({0.0f, -1.0f, 0.0f}).y, 3.0f, 1e-4f);
}

TEST(Environment, packets_equal_single_look_ups) {
  Background b = panorama(8, 4, [](int x, int y) { return Vec3f(static_cast<float>(x), static_cast<float>(y), 1.0f); });
  b.map->rotation = 0.7f, b.map->strength = 1.5f;
  Background sky;
  sky.zenith = Vec3f(1.0f, 2.0f, 3.0f);
  for (const Background* background : {&b, &sky}) {
    const Environment e(*background);
    SkyRays rays;
    for (std::uint32_t i = 0; i < SkyRays::kRays; ++i) {
      const Vec3f d = i < 2 ? Vec3f(0.0f, i == 0 ? 1.0f : -1.0f, 0.0f) : sample_cosine(scrambled_sobol(i, 3u));
      rays.x[i] = d.x, rays.y[i] = d.y, rays.z[i] = d.z;
    }
    e.radiance(rays);
    for (int i = 0; i < SkyRays::kRays; ++i) {
      const Vec3f direction(rays.x[i], rays.y[i], rays.z[i]);
      EXPECT_EQ(e.radiance(direction), Vec3f(rays.red[i], rays.green[i], rays.blue[i])) << i;
    }
  }
}

TEST(Environment, packets_equal_single_samples) {
  Background b = panorama(37, 20, [](int x, int y) { return Vec3f(static_cast<float>(x % 5), static_cast<float>(y), 1.0f); });
  b.map->rotation = 0.7f, b.map->strength = 1.5f;
  Background grey = panorama(16, 8, [](int x, int y) { return Vec3f(static_cast<float>((x * 5 + y * 3) % 7)); });
  Background sky;
  sky.zenith = Vec3f(1.0f, 2.0f, 3.0f);
  for (const Background* background : {&b, &grey, &sky}) {
    const Environment e(*background);
    SkyDraws draws;
    for (std::uint32_t i = 0; i < SkyDraws::kDraws; ++i) {
      const Vec2f u = i == 0 ? Vec2f(0.0f) : i == 1 ? Vec2f(0x1.fffffep-1f) : scrambled_sobol(i, 3u);
      draws.u[i] = u.x, draws.v[i] = u.y;
    }
    e.sample_rest(draws);
    for (int i = 0; i < SkyDraws::kDraws; ++i) {
      const Environment::Sample alone = e.sample_rest(Vec2f(draws.u[i], draws.v[i]));
      EXPECT_EQ(alone.direction, Vec3f(draws.x[i], draws.y[i], draws.z[i])) << i;
      EXPECT_EQ(alone.density, draws.density[i]) << i;
      EXPECT_EQ(alone.radiance, Vec3f(draws.red[i], draws.green[i], draws.blue[i])) << i;
    }
  }
}

TEST(Environment, samples_have_their_directions_radiance) {
  Background b = panorama(37, 20, [](int x, int y) { return Vec3f(static_cast<float>(x % 5), static_cast<float>(y), 1.0f); });
  b.map->strength = 1.5f;
  for (const float rotation : {0.7f, -1000.0f, 1e30f}) {
    b.map->rotation = rotation;
    const Environment e(b);
    for (std::uint32_t i = 0; i < 500; ++i) {
      const Environment::Sample s = e.sample_rest(scrambled_sobol(i, 9u));
      EXPECT_NEAR(glm::length(s.direction), 1.0f, 1e-6f) << i;
      const Vec3f seen = e.radiance(s.direction);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(s.radiance[c], seen[c], 1e-4f * (1.0f + seen[c])) << i << ", turned by " << rotation;
    }
  }
}

TEST(Environment, rotation_moves_x_towards_z) {
  Background b = panorama(8, 4, [](int x, int) { return Vec3f(x == 4 ? 1.0f : 0.0f); });
  b.map->rotation = radians(90.0f);
  const float angle = radians(112.5f);
  EXPECT_NEAR(Environment(b).radiance({std::cos(angle), 0.0f, std::sin(angle)}).x, 1.0f, 1e-4f);
}

/// A panorama of radiance 1, in which one texel, 1.4 degrees wide, has as much light as all others together.
Background sunny(int sun_x, int sun_y) {
  constexpr int kWidth = 256, kHeight = 128;
  const double step = M_PI / kHeight, texel = (std::cos(step * sun_y) - std::cos(step * (sun_y + 1))) * 2.0 * M_PI / kWidth;
  return panorama(kWidth, kHeight, [&](int x, int y) {
    return Vec3f(x == sun_x && y == sun_y ? static_cast<float>(4.0 * M_PI / texel) : 1.0f);
  });
}

void for_each_direction(const Background& b, int within, const std::function<void(Vec3f, double)>& fn) {
  const int width = b.map->radiance.width * within, height = b.map->radiance.height * within;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double polar = M_PI * (y + 0.5) / height, azimuth = 2.0 * M_PI * (x + 0.5) / width - M_PI;
      fn(Vec3f(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)),
         std::sin(polar) * M_PI / height * 2.0 * M_PI / width);
    }
}

TEST(Environment, directions_follow_their_density) {
  Background b =
      panorama(16, 8, [](int x, int y) { return Vec3f(x == 3 && y == 2 ? 50.0f : static_cast<float>((x * 7 + y) % 5)); });
  b.map->rotation = 1.0f;
  Background sky;
  sky.zenith = Vec3f(1.0f, 2.0f, 3.0f);
  for (const Background* background : {&b, &sky}) {
    const Environment e(*background);
    const auto draw = [&](int i) -> std::optional<Vec3f> {
      return e.sample_rest(scrambled_sobol(0, static_cast<std::uint32_t>(i))).direction;
    };
    const auto density = [&](Vec3f d) { return static_cast<double>(density_of(e, d).value); };
    EXPECT_LT(test::chi_squared(200'000, draw, density).deviations(), 4.0);
  }
}

TEST(Environment, samples_have_their_directions_density) {
  const Background b = panorama(16, 8, [](int x, int y) { return Vec3f(static_cast<float>(1 + (x * 5 + y * 3) % 7)); });
  const Environment e(b);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Environment::Sample s = e.sample_rest(scrambled_sobol(i, 4u));
    EXPECT_NEAR(s.density, density_of(e, s.direction).value, 1e-3f * s.density) << i;
  }
}

TEST(Environment, one_texel_suns_are_found_anywhere) {
  for (const Vec2i at : {Vec2i(100, 40), Vec2i(0, 64), Vec2i(255, 64), Vec2i(30, 0), Vec2i(255, 0), Vec2i(0, 127)}) {
    const Background b = sunny(at.x, at.y);
    const Environment e(b);
    // The sun, one texel, has as much light as all other texels together, so its share is 1/2. In a row at a pole,
    // interpolation spreads the sun over a larger solid angle. It then has 1.25 times the light of the other texels, a
    // share of 1.25 / 2.25.
    EXPECT_NEAR(e.sun_share(), at.y % 127 == 0 ? 1.25f / 2.25f : 0.5f, 0.002f) << at.x << ", " << at.y;
    double solid_angle = 0.0;
    for_each_direction(b, 3, [&](Vec3f d, double steradian) {
      const bool of_sun = density_of(e, d).of_sun;
      solid_angle += of_sun ? steradian : 0.0;
      EXPECT_TRUE(of_sun || e.radiance(d).y <= 1.01f) << "the sun's light extends beyond it, at " << at.x << ", " << at.y;
    });
    EXPECT_LT(solid_angle, 0.0025);  // limit: two by two texels
  }
}

TEST(Environment, sun_and_rest_integrate_to_one) {
  Background b = sunny(200, 50);
  b.map->rotation = 0.3f;
  const Environment e(b);
  double of_sun = 0.0, of_rest = 0.0, light = 0.0;
  for_each_direction(b, 6, [&](Vec3f d, double steradian) {
    const Environment::Density density = density_of(e, d);
    (density.of_sun ? of_sun : of_rest) += static_cast<double>(density.value) * steradian;
    light += static_cast<double>(e.radiance(d).y) * steradian;
  });
  EXPECT_NEAR(of_sun, 1.0, 0.01);
  EXPECT_NEAR(of_rest, 1.0, 0.001);
  constexpr int kSamples = 4096;
  double sampled = 0.0;
  for (std::uint32_t i = 0; i < kSamples; ++i)
    for (const Environment::Sample& s : {e.sample_sun(scrambled_sobol(i, 5u)), e.sample_rest(scrambled_sobol(i, 6u))})
      sampled += static_cast<double>(e.radiance(s.direction).y / s.density) / kSamples;
  EXPECT_NEAR(sampled, light, 0.002 * light);
}

// The density is proportional to the radiance, so every sample of the sun gives the same estimate.
TEST(Environment, samples_of_a_sun_have_no_noise) {
  const Background b = sunny(200, 50);
  const Environment e(b);
  const double of_sun = static_cast<double>(e.sun_share() * e.mean_radiance().y) * 4.0 * M_PI;
  for (std::uint32_t i = 0; i < 256; ++i) {
    const Environment::Sample s = e.sample_sun(scrambled_sobol(i, 7u));
    ASSERT_TRUE(density_of(e, s.direction).of_sun) << i;
    EXPECT_NEAR(static_cast<double>(e.radiance(s.direction).y / s.density), of_sun, 0.02 * of_sun) << i;
  }
}

TEST(Environment, soft_skies_have_no_sun) {
  Background gradient;
  gradient.zenith = Vec3f(1.0f), gradient.horizon_at = 0.99f;
  const Background even = panorama(256, 128, [](int, int) { return Vec3f(2.0f); }),
                   dark = panorama(256, 128, [](int, int) { return Vec3f(0.0f); }),
                   // nearly all the light is in 0.15 steradian
      window = panorama(256, 128, [](int x, int y) { return Vec3f(x < 16 && y > 56 && y < 72 ? 1000.0f : 0.1f); }),
                   // One texel is 200 times as bright as the rest, but has only a hundredth of all light.
      veiled = panorama(256, 128, [](int x, int y) { return Vec3f(x == 9 && y == 60 ? 200.0f : 1.0f); });
  for (const Background* b : std::initializer_list<const Background*>{&gradient, &even, &dark, &window, &veiled}) {
    const Environment e(*b);
    EXPECT_EQ(e.sun_share(), 0.0f);
    EXPECT_FALSE(density_of(e, {0.0f, 0.0f, 1.0f}).of_sun);
  }
}

TEST(Environment, mean_radiance_and_darkness_are_known) {
  Background even;
  even.horizon = even.zenith = Vec3f(0.5f);
  EXPECT_NEAR(Environment(even).mean_radiance().y, 0.5f, 1e-4f);
  EXPECT_TRUE(Environment(Background{}).is_dark());
  EXPECT_EQ(density_of(Environment(Background{}), {0.0f, 1.0f, 0.0f}).value, 0.0f);
}

}  // namespace
}  // namespace lippmann

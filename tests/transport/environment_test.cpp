#include "transport/environment.hpp"

#include <gtest/gtest.h>

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

// Eight columns of 45 degrees; column 4 begins at +x, and z grows with the column.
TEST(Environment, a_panorama_lies_as_documented) {
  Background b = panorama(8, 4, [](int x, int y) { return Vec3f(static_cast<float>(x), static_cast<float>(y), 1.0f); });
  const Environment e(b);
  const float turn = radians(22.5f);  // to the middle of a column
  const Vec3f x_axis = e.radiance({std::cos(turn) * std::cos(turn), std::sin(turn), std::sin(turn) * std::cos(turn)});
  EXPECT_NEAR(x_axis.x, 4.0f, 1e-4f);
  EXPECT_NEAR(x_axis.y, 1.0f, 1e-4f);  // row 1 is centred 22.5 degrees above the horizon
  const float quarter = radians(112.5f);
  EXPECT_NEAR(e.radiance({std::cos(quarter), 0.0f, std::sin(quarter)}).x, 6.0f, 1e-4f);  // beyond +z
  EXPECT_NEAR(e.radiance({0.0f, 1.0f, 0.0f}).y, 0.0f, 1e-4f);
  EXPECT_NEAR(e.radiance({0.0f, -1.0f, 0.0f}).y, 3.0f, 1e-4f);
}

TEST(Environment, directions_side_by_side_see_what_each_alone_sees) {
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
    for (int i = 0; i < SkyRays::kRays; ++i)
      EXPECT_EQ(e.radiance({rays.x[i], rays.y[i], rays.z[i]}), Vec3f(rays.red[i], rays.green[i], rays.blue[i])) << i;
  }
}

TEST(Environment, turning_moves_what_lies_along_x_towards_z) {
  Background b = panorama(8, 4, [](int x, int) { return Vec3f(x == 4 ? 1.0f : 0.0f); });
  b.map->rotation = radians(90.0f);
  const float angle = radians(112.5f);
  EXPECT_NEAR(Environment(b).radiance({std::cos(angle), 0.0f, std::sin(angle)}).x, 1.0f, 1e-4f);
}

TEST(Environment, directions_are_drawn_as_their_density_says) {
  Background b =
      panorama(16, 8, [](int x, int y) { return Vec3f(x == 3 && y == 2 ? 50.0f : static_cast<float>((x * 7 + y) % 5)); });
  b.map->rotation = 1.0f;
  Background sky;
  sky.zenith = Vec3f(1.0f, 2.0f, 3.0f);
  for (const Background* background : {&b, &sky}) {
    const Environment e(*background);
    const auto draw = [&](int i) -> std::optional<Vec3f> {
      return e.sample(scrambled_sobol(0, static_cast<std::uint32_t>(i))).direction;
    };
    EXPECT_LT(test::chi_squared(200'000, draw, [&](Vec3f d) { return static_cast<double>(e.density(d)); }).deviations(), 4.0);
  }
}

TEST(Environment, a_samples_density_is_that_of_its_direction) {
  const Background b = panorama(16, 8, [](int x, int y) { return Vec3f(static_cast<float>(1 + (x * 5 + y * 3) % 7)); });
  const Environment e(b);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Environment::Sample s = e.sample(scrambled_sobol(i, 4u));
    EXPECT_NEAR(s.density, e.density(s.direction), 1e-3f * s.density) << i;
  }
}

TEST(Environment, an_even_one_has_its_radiance_as_mean_and_a_dark_one_says_so) {
  Background even;
  even.horizon = even.zenith = Vec3f(0.5f);
  EXPECT_NEAR(Environment(even).mean_radiance().y, 0.5f, 1e-4f);
  EXPECT_TRUE(Environment(Background{}).is_dark());
  EXPECT_EQ(Environment(Background{}).density({0.0f, 1.0f, 0.0f}), 0.0f);
}

}  // namespace
}  // namespace lippmann

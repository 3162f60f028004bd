#include "scene/builtin/textures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lippmann::builtin {
namespace {

TEST(Paint, encodes_linear_colors_as_srgb) {
  // Linear 0.5 has the sRGB code 188, linear 0.001 the code 12.92 * 0.001 * 255 = 3.3. Values above 1 become 255.
  const Texture texture =
      paint("t", 2, 1, [](Vec2f uv) { return uv.x < 0.5f ? Vec3f(0.5f, 0.001f, 0.0f) : Vec3f(7.0f, -1.0f, 1.0f); });
  EXPECT_EQ(texture.rgba, (std::vector<std::uint8_t>{188, 3, 0, 255, 255, 0, 255, 255}));
  EXPECT_TRUE(texture.srgb);
}

TEST(Paint, samples_texel_centres_from_the_top_left) {
  const Texture texture = paint("t", 2, 2, [](Vec2f uv) {
    EXPECT_TRUE(uv.x == 0.25f || uv.x == 0.75f);
    return Vec3f(uv.y < 0.5f ? 1.0f : 0.0f);
  });
  EXPECT_EQ(texture.rgba[0], 255);
  EXPECT_EQ(texture.rgba[8], 0);
}

TEST(Noise, zero_on_lattice_points_and_bounded) {
  EXPECT_EQ(noise({3.0f, 5.0f}, {8, 8}, 1), 0.0f);
  for (int i = 0; i < 1000; ++i) {
    const float n = noise({0.37f * static_cast<float>(i), 0.61f * static_cast<float>(i)}, {8, 8}, 1);
    EXPECT_LE(std::abs(n), 1.0f);
  }
}

TEST(Noise, repeats_after_its_period) {
  for (const Vec2f p : {Vec2f(0.3f, 0.7f), Vec2f(4.9f, 2.2f)}) {
    EXPECT_NEAR(noise(p, {5, 3}, 2), noise(p + Vec2f(5, 0), {5, 3}, 2), 1e-5f);
    EXPECT_NEAR(noise(p, {5, 3}, 2), noise(p + Vec2f(0, 3), {5, 3}, 2), 1e-5f);
  }
}

TEST(FractalNoise, repeats_after_its_period) {
  const Vec2f p(1.3f, 2.7f);
  EXPECT_NEAR(fractal_noise(p, {4, 4}, 5, 3), fractal_noise(p + Vec2f(4, 4), {4, 4}, 5, 3), 1e-4f);
}

int greatest_step(const Texture& t, bool seam_only) {
  int most = 0;
  const auto at = [&](int x, int y, int c) { return int{t.rgba[static_cast<std::size_t>(4 * (y * t.width + x) + c)]}; };
  for (int y = 0; y < t.height; ++y)
    for (int x = seam_only ? t.width - 1 : 0; x < t.width; ++x)
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(at(x, y, c) - at((x + 1) % t.width, y, c)));
  return most;
}

TEST(Globe, has_no_seam) {
  const Texture texture = globe({0.03f, 0.12f, 0.28f}, {0.10f, 0.24f, 0.06f});
  EXPECT_LE(greatest_step(texture, true), greatest_step(texture, false));
  EXPECT_LT(greatest_step(texture, true), 128);
}

}  // namespace
}  // namespace lippmann::builtin

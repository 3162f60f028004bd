#include "scene/texture_budget.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using lippmann::halvings_within;
using lippmann::Texture;
using lippmann::TextureExtent;
using lippmann::Vec2i;
using testing::ElementsAre;

Texture of_codes(Vec2i size, std::vector<std::uint8_t> rgba, bool srgb) {
  Texture texture;
  texture.width = size.x, texture.height = size.y;
  texture.srgb = srgb;
  texture.rgba = std::move(rgba);
  return texture;
}

TEST(TextureBudget, textures_that_fit_stay_as_they_are) {
  const std::vector<TextureExtent> two{{{8, 8}, false}, {{4, 4}, true}};  // textures of 256 and 64 bytes
  EXPECT_THAT(halvings_within(320, two), ElementsAre(0, 0));
}

TEST(TextureBudget, the_largest_is_halved_first) {
  // textures of 64, 1024 and 64 bytes
  const std::vector<TextureExtent> three{{{4, 4}, true}, {{16, 16}, false}, {{4, 4}, true}};
  EXPECT_THAT(halvings_within(1151, three), ElementsAre(0, 1, 0));
  EXPECT_THAT(halvings_within(383, three), ElementsAre(0, 2, 0));  // one halving leaves 64 + 256 + 64 = 384 bytes
}

TEST(TextureBudget, equal_sizes_reduce_data_and_later_first) {
  const std::vector<TextureExtent> four{{{4, 4}, true}, {{4, 4}, false}, {{4, 4}, true}, {{4, 4}, false}};
  EXPECT_THAT(halvings_within(255, four), ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(halvings_within(207, four), ElementsAre(1, 0, 1, 0));
  EXPECT_THAT(halvings_within(159, four), ElementsAre(1, 0, 1, 1));
}

TEST(TextureBudget, single_texels_are_not_halved) {
  const std::vector<TextureExtent> two{{{2, 1}, true}, {{1, 1}, true}};
  EXPECT_THAT(halvings_within(1, two), ElementsAre(1, 0));
}

TEST(TextureBudget, long_textures_are_halved_on_both_sides) {
  EXPECT_EQ(lippmann::halved({7, 1}), Vec2i(3, 1));
  EXPECT_THAT(halvings_within(4, std::vector<TextureExtent>{{{8, 1}, true}}), ElementsAre(3));
}

TEST(HalvedTexture, averages_colours_linearly_and_alpha_directly) {
  // Red: one texel of linear value 1 and three of 0 have the mean 1/4, the sRGB code 137. The mean of the bytes would
  // be 64.
  Texture texture = of_codes({2, 2}, {255, 0, 255, 255, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0}, true);
  lippmann::halve(texture);
  EXPECT_EQ(Vec2i(texture.width, texture.height), Vec2i(1, 1));
  EXPECT_THAT(texture.rgba, ElementsAre(137, 0, 255, 64));
}

TEST(HalvedTexture, data_are_averaged_as_they_are) {
  Texture texture = of_codes({2, 1}, {10, 0, 255, 0, 20, 0, 255, 255}, false);
  lippmann::halve(texture);
  EXPECT_THAT(texture.rgba, ElementsAre(15, 0, 255, 128));
}

TEST(HalvedTexture, last_odd_texel_covers_three) {
  Texture texture = of_codes({5, 1}, {10, 0, 0, 0, 20, 0, 0, 0, 30, 0, 0, 0, 40, 0, 0, 0, 50, 0, 0, 0}, false);
  lippmann::halve(texture);
  EXPECT_THAT(texture.rgba, ElementsAre(15, 0, 0, 0, 40, 0, 0, 0));
}

TEST(HalvedTexture, uniform_colours_are_unchanged) {
  for (const bool srgb : {false, true})
    for (int code = 0; code < 256; ++code) {
      const auto c = static_cast<std::uint8_t>(code);
      Texture texture = of_codes({2, 1}, {c, c, c, c, c, c, c, c}, srgb);
      lippmann::halve(texture);
      EXPECT_THAT(texture.rgba, ElementsAre(c, c, c, c)) << "srgb " << srgb;
    }
}

}  // namespace

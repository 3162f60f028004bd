#include "image/draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

Picture white_picture(int width, int height) {
  Picture picture = Image8{width, height, std::vector<unsigned char>(std::size_t{3} * width * height)};
  fill_box(picture, {{0, 0}, {width, height}}, kWhiteRgb);
  return picture;
}

/// '#' is ink and '.' paper.
std::string drawing_of(const Picture& picture) {
  const auto& image = std::get<Image8>(picture);
  std::string text;
  for (int y = 0; y < image.height; ++y, text += '\n')
    for (int x = 0; x < image.width; ++x) text += image.rgb[3 * static_cast<std::size_t>(y * image.width + x)] == 0 ? '#' : '.';
  return text;
}

TEST(Draw, boxes_are_clipped_at_the_edges) {
  Picture picture = white_picture(4, 3);
  fill_box(picture, {{2, 1}, {90, 90}}, kBlackRgb);
  fill_box(picture, {{-5, -5}, {1, 1}}, kBlackRgb);
  fill_box(picture, {{3, 2}, {1, 0}}, kBlackRgb);
  EXPECT_EQ(drawing_of(picture), "#...\n..##\n..##\n");
}

TEST(Draw, colours_become_samples_of_the_kind) {
  Picture words = Image16{1, 1, std::vector<std::uint16_t>(3)}, light = Image(1, 1, 3);
  for (Picture* picture : {&words, &light}) fill_box(*picture, {{0, 0}, {1, 1}}, {1, 128, 255});
  EXPECT_EQ(std::get<Image16>(words).rgb, (std::vector<std::uint16_t>{257, 128 * 257, 65535}));
  EXPECT_EQ(std::get<Image>(light).data[1], static_cast<float>(linear_from_srgb(128.0 / 255.0)));
  EXPECT_EQ(std::get<Image>(light).data[2], 1.0f);
}

TEST(Draw, text_is_made_of_whole_units) {
  Picture one = white_picture(8, 12), three = white_picture(24, 36);
  draw_text(one, {1, 1}, 1, "1");
  draw_text(three, {3, 3}, 3, "1");
  const std::string small = drawing_of(one), large = drawing_of(three);
  EXPECT_GT(std::count(small.begin(), small.end(), '#'), 6);
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 24; ++x)
      ASSERT_EQ(large[static_cast<std::size_t>(y * 25 + x)], small[static_cast<std::size_t>(y / 3 * 9 + x / 3)])
          << x << ' ' << y;
  EXPECT_EQ(small.substr(0, 9), "........\n");
}

TEST(Draw, digits_differ) {
  std::vector<std::string> drawings;
  for (const char digit : std::string("0123456789.-")) {
    Picture picture = white_picture(8, 12);
    draw_text(picture, {1, 1}, 1, std::string(1, digit));
    drawings.push_back(drawing_of(picture));
  }
  std::sort(drawings.begin(), drawings.end());
  EXPECT_EQ(std::unique(drawings.begin(), drawings.end()), drawings.end());
}

TEST(Draw, text_lies_within_its_units) {
  const std::string text = "62.5 lpi\n9.6 px";
  const Vec2i units = text_units(text);
  EXPECT_EQ(units.y, 2 * kTextLine);
  Picture exact = white_picture(units.x, units.y), larger = white_picture(units.x + 20, units.y + 20);
  draw_text(exact, {0, 0}, 1, text);
  draw_text(larger, {0, 0}, 1, text);
  const std::string inside = drawing_of(exact), all = drawing_of(larger);
  EXPECT_EQ(std::count(inside.begin(), inside.end(), '#'), std::count(all.begin(), all.end(), '#'));
}

}  // namespace
}  // namespace lippmann

#include "layout/sub_pixels.hpp"

#include <gtest/gtest.h>

#include "lippmann/core/math.hpp"

namespace lippmann {
namespace {

Image counting_film() {
  Image film(6, 2, 3);
  for (std::size_t i = 0; i < film.data.size(); ++i) film.data[i] = static_cast<float>(i);
  return film;
}

TEST(SubPixels, joins_colours_of_sub_pixels) {
  const Image frame = join_sub_pixels(counting_film());
  EXPECT_EQ(Vec2i(frame.width, frame.height), Vec2i(2, 2));
  // The film is 6 pixels wide, and channel c of its pixel (x, y) has the value 18 y + 3 x + c. Colour c of frame pixel
  // (i, j) is channel c of film pixel (3 i + c, j).
  EXPECT_EQ(frame.data, (std::vector<float>{0, 4, 8, 9, 13, 17, 18, 22, 26, 27, 31, 35}));
}

TEST(SubPixels, other_layers_use_the_middle_sub_pixel) {
  EXPECT_EQ(middle_sub_pixels(counting_film()).data, (std::vector<float>{3, 4, 5, 12, 13, 14, 21, 22, 23, 30, 31, 32}));
}

}  // namespace
}  // namespace lippmann

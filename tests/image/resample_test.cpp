#include "image/resample.hpp"

#include <gmock/gmock.h>

namespace lippmann {
namespace {

using testing::ElementsAre;
using testing::FloatEq;

Image grey(int width, int height, std::vector<float> samples) {
  Image image(width, height, 1);
  image.data = std::move(samples);
  return image;
}

TEST(Resample, same_size_is_the_same_picture) {
  EXPECT_THAT(resampled(grey(2, 2, {1, 2, 3, 4}), {2, 2}).data, ElementsAre(1, 2, 3, 4));
}

TEST(Resample, half_size_averages_two_pixels) {
  EXPECT_THAT(resampled(grey(4, 1, {1, 3, 5, 9}), {2, 1}).data, ElementsAre(2, 7));
  EXPECT_THAT(resampled(grey(1, 4, {1, 3, 5, 9}), {1, 2}).data, ElementsAre(2, 7));
}

TEST(Resample, twice_the_size_repeats) {
  EXPECT_THAT(resampled(grey(2, 1, {1, 3}), {4, 2}).data, ElementsAre(1, 1, 3, 3, 1, 1, 3, 3));
}

TEST(Resample, partly_covered_pixels_are_weighted) {
  // Each output pixel covers 1.5 input pixels: (1 + 2 / 2) / 1.5 = 4/3 and (2 / 2 + 3) / 1.5 = 8/3.
  EXPECT_THAT(resampled(grey(3, 1, {1, 2, 3}), {2, 1}).data, ElementsAre(FloatEq(4.0f / 3.0f), FloatEq(8.0f / 3.0f)));
}

}  // namespace
}  // namespace lippmann

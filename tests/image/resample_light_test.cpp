#include "image/resample_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lippmann {
namespace {

Image row_of(const std::vector<float>& values) {
  Image image(static_cast<int>(values.size()), 1, 3);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < 3; ++c) image.data[3 * i + static_cast<std::size_t>(c)] = values[i];
  return image;
}

std::vector<float> resampled_row(const std::vector<float>& values, const AxisSamples& across) {
  const ThreadPool pool(1);
  const Image made = resampled_light(row_of(values), across, {}, pool);
  std::vector<float> row;
  for (int x = 0; x < made.width; ++x) row.push_back(made.pixel(x, 0)[0]);
  return row;
}

TEST(ResampledLight, keeps_coinciding_samples) {
  EXPECT_EQ(resampled_row({1, 5, 2, 7}, {1.0, 1.0, 3}), (std::vector<float>{5, 2, 7}));
}

TEST(ResampledLight, reduces_by_area) {
  EXPECT_EQ(resampled_row({1, 5, 2, 7}, {0.0, 2.0, 2}), (std::vector<float>{3, 4.5}));
  const std::vector<float> row = resampled_row({1, 5, 2, 7}, {0.5, 1.5, 2});
  EXPECT_FLOAT_EQ(row[0], (0.5f * 1 + 5) / 1.5f);
  EXPECT_FLOAT_EQ(row[1], (2 + 0.5f * 7) / 1.5f);
}

// Halfway between two samples, the Lanczos filter sinc(x) sinc(x / 3) has the distances x = 1/2, 3/2 and 5/2 on both
// sides.
TEST(ResampledLight, enlarges_by_lanczos) {
  const auto lobe = [](double x) {
    const double a = std::numbers::pi * x;
    return std::sin(a) / a * std::sin(a / 3.0) / (a / 3.0);
  };
  const double sum = 2.0 * (lobe(0.5) + lobe(1.5) + lobe(2.5));
  // the output pixel covers 4.75 to 5.25
  const std::vector<float> row = resampled_row({0, 0, 0, 0, 1, 0, 0, 0, 0}, {4.75, 0.5, 1});
  EXPECT_NEAR(row[0], lobe(0.5) / sum, 1e-6);
}

TEST(ResampledLight, edges_continue_or_are_black) {
  EXPECT_EQ(resampled_row({3, 3}, {-2.0, 1.0, 5}), (std::vector<float>{3, 3, 3, 3, 3}));
  EXPECT_EQ(resampled_row({3, 3}, {-2.0, 1.0, 5, true}), (std::vector<float>{0, 0, 3, 3, 0}));
}

TEST(ResampledLight, mixes_light_not_codes) {
  const ThreadPool pool(1);
  const Image8 codes{2, 1, {0, 0, 0, 255, 255, 255}};
  EXPECT_FLOAT_EQ(resampled_light(codes, {0.0, 2.0, 1}, {}, pool).data[0], 0.5f);
}

}  // namespace
}  // namespace lippmann

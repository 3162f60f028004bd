#include "lippmann/image/encode.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/random.hpp"

namespace lippmann {
namespace {

using ::testing::ElementsAre;

Image one_row(std::vector<float> values, int channels) {
  Image image(static_cast<int>(values.size()) / channels, 1, channels);
  image.data = std::move(values);
  return image;
}

int srgb_reference(float value, int max_code) {
  const double v = std::clamp<double>(value, 0.0, 1.0);
  const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::floor(max_code * s + 0.5));
}

TEST(SrgbCurve, known_values) {
  EXPECT_DOUBLE_EQ(srgb_from_linear(0.0), 0.0);
  EXPECT_DOUBLE_EQ(srgb_from_linear(1.0), 1.0);
  EXPECT_NEAR(srgb_from_linear(0.5), 0.735357, 1e-6);
  EXPECT_NEAR(srgb_from_linear(0.002), 0.02584, 1e-12);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.214041, 1e-6);
}

TEST(SrgbCurve, inverse_undoes_it) {
  for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 1000.0)), i / 1000.0, 1e-7);
}

TEST(ToCodes, srgb_codes_are_exact_at_every_step) {
  std::vector<float> values;
  for (int code = 1; code < 256; ++code) {
    const auto step = std::bit_cast<std::uint32_t>(static_cast<float>(linear_from_srgb((code - 0.5) / 255.0)));
    for (int ulps = -20; ulps <= 20; ++ulps) values.push_back(std::bit_cast<float>(step + ulps));
  }
  const Image8 codes = to_codes(one_row(values, 3), Encoding::kSrgb);
  for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(codes.rgb[i], srgb_reference(values[i], 255)) << values[i];
}

TEST(ToCodes, srgb_codes_are_exact_for_random_floats) {
  std::vector<float> values;
  for (std::uint32_t i = 0; values.size() < 300000; ++i) {
    const float value = std::bit_cast<float>(hash(i));
    if (!std::isnan(value)) values.push_back(i % 2 ? value : unit_float(hash(i, 1u)));
  }
  const Image8 codes = to_codes(one_row(values, 3), Encoding::kSrgb);
  for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(codes.rgb[i], srgb_reference(values[i], 255)) << values[i];
}

TEST(ToCodes, every_code_survives_a_round_trip) {
  std::vector<float> values;
  for (int code = 0; code < 256; ++code)
    for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(linear_from_srgb(code / 255.0)));
  const Image8 codes = to_codes(one_row(values, 3), Encoding::kSrgb);
  for (int code = 0; code < 256; ++code) EXPECT_EQ(codes.rgb[3 * code], code);
}

TEST(ToCodes, truncate_drops_the_fraction) {
  const Image film = one_row({0.0f, 0.5f, 1.0f, 0.00392f, 0.00393f, 0.9999f}, 3);
  EXPECT_THAT(to_codes(film, Encoding::kTachyonTruncate).rgb, ElementsAre(0, 127, 255, 0, 1, 254));
}

TEST(ToCodes, values_are_clamped_and_nan_is_counted) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const Image film = one_row({-1.0f, 2.0f, nan, -inf, inf, -nan}, 3);
  for (const Encoding encoding : {Encoding::kSrgb, Encoding::kTachyonTruncate}) {
    std::size_t nans = 99;
    EXPECT_THAT(to_codes(film, encoding, &nans).rgb, ElementsAre(0, 255, 0, 0, 255, 0));
    EXPECT_EQ(nans, 2u);
    EXPECT_THAT(to_codes16(film, encoding, &nans).rgb, ElementsAre(0, 65535, 0, 0, 65535, 0));
    EXPECT_EQ(nans, 2u);
  }
}

TEST(ToCodes, grey_is_repeated_extra_channels_are_dropped) {
  EXPECT_THAT(to_codes(one_row({0.0f, 1.0f}, 1), Encoding::kSrgb).rgb, ElementsAre(0, 0, 0, 255, 255, 255));
  EXPECT_THAT(to_codes(one_row({1.0f, 0.0f}, 2), Encoding::kSrgb).rgb, ElementsAre(255, 255, 255));
  EXPECT_THAT(to_codes(one_row({1.0f, 0.0f, 0.5f, 0.25f}, 4), Encoding::kSrgb).rgb, ElementsAre(255, 0, 188));
}

TEST(ToCodes16, srgb_codes_equal_the_formula) {
  std::vector<float> values;
  for (std::uint32_t i = 0; i < 30000; ++i) values.push_back(unit_float(hash(i)));
  const Image16 codes = to_codes16(one_row(values, 3), Encoding::kSrgb);
  for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(codes.rgb[i], srgb_reference(values[i], 65535)) << values[i];
}

TEST(ToCodes16, truncate_drops_the_fraction) {
  EXPECT_THAT(to_codes16(one_row({0.5f, 1.0f, 0.25f}, 3), Encoding::kTachyonTruncate).rgb, ElementsAre(32767, 65535, 16383));
}

}  // namespace
}  // namespace lippmann

// How many samples the pixels of a block should have, worked out by hand.
#include "trace/block_estimates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace lippmann {
namespace {

constexpr std::size_t kPixels = 40;  // two packets and a half
constexpr float kError = 0.01f;

/// Grey pixels, `samples` of 0.2 each.
std::unique_ptr<BlockEstimates> even(int samples) {
  auto block = std::make_unique<BlockEstimates>();
  for (std::uint32_t e = 0; e < kPixels; ++e) {
    block->push_back(100 + e, 0.0f);
    for (int s = 0; s < samples; ++s) block->add(e, Vec3f(0.2f));
  }
  return block;
}

void look(BlockEstimates& block, float have) {
  encode(block);
  find_wanted(have, kError, block);
}

/// Of sRGB's curve above its toe.
double code(double luminance) { return 1.055 * std::pow(luminance, 1.0 / 2.4) - 0.055; }

TEST(BlockEstimates, even_light_wants_nothing) {
  const auto block = even(2);
  look(*block, 2.0f);
  for (std::size_t e = 0; e < kPixels; ++e) EXPECT_LT(block->wanted[e], 0.01f) << e;
  EXPECT_EQ(block->pixel[7], 107u);
  EXPECT_NEAR(block->radiance(7).y, 0.2f, 1e-6f);
}

TEST(BlockEstimates, scatter_is_that_of_one_sample_as_codes_have_it) {
  auto block = even(2);
  block->add(7, Vec3f(0.21f));
  block->add(7, Vec3f(0.19f));  // deviations 0, 0, 0.01, -0.01: squared 2 / 3 of 1e-4
  encode(*block);
  const double slope = (code(0.2001) - code(0.1999)) / 0.0002;
  EXPECT_NEAR(static_cast<double>(block->scatter[kLanes + 7]), slope * slope * 2.0 / 3.0 * 1e-4, 1e-6);
}

// Of four samples one is open: alpha scatters by 3/4 x 1/4 x 4/3. The light of all is the same.
TEST(BlockEstimates, alpha_scatters_as_a_channel_of_its_own) {
  auto block = even(4);
  block->push_back(200, 0.0f);
  for (int s = 0; s < 4; ++s) block->add(kPixels, Vec3f(0.2f), s == 0 ? 1.0f : 0.0f);
  look(*block, 4.0f);
  EXPECT_FLOAT_EQ(block->alpha(kPixels), 0.75f);
  EXPECT_FLOAT_EQ(block->scatter[kLanes + kPixels], 0.25f);
  EXPECT_FLOAT_EQ(block->alpha(7), 1.0f);
  EXPECT_GT(block->wanted[kPixels - 1], 1.0f) << "its neighbour may have missed the edge";
  EXPECT_LT(block->wanted[7], 0.01f);
}

// A scatter of s^2 wants (s / error)^(2 / 2.6) samples.
TEST(BlockEstimates, samples_grow_with_scatter) {
  auto block = even(8);
  for (int s = 0; s < 8; ++s) block->add(20, Vec3f(s % 2 ? 0.2f + 0.03f : 0.2f - 0.03f));
  look(*block, 8.0f);
  const double expected = std::pow(static_cast<double>(block->scatter[kLanes + 20]) / (kError * kError), 1.0 / 2.6);
  EXPECT_GT(expected, 2.0);
  EXPECT_NEAR(static_cast<double>(block->wanted[20]), expected, 1e-3 * expected);
  EXPECT_LT(block->wanted[25], 0.01f);
}

// Two samples say little: neighbours along and across rays share their scatter, while there are no more than four.
TEST(BlockEstimates, neighbours_share_what_few_samples_scatter) {
  for (const int samples : {2, 8}) {
    auto block = even(samples);
    for (int s = 0; s < samples; ++s) block->add(20, Vec3f(s % 2 ? 0.201f : 0.199f));
    look(*block, static_cast<float>(samples));
    for (const std::size_t e : {std::size_t{19}, std::size_t{21}, std::size_t{4}, std::size_t{36}})
      EXPECT_EQ(block->wanted[e] > 0.05f, samples == 2) << e << " of " << samples;
    for (const std::size_t e : {std::size_t{18}, std::size_t{5}, std::size_t{35}}) EXPECT_LT(block->wanted[e], 0.01f) << e;
  }
}

// A bright pixel beside a grey one: two grey samples may have missed a quarter of it, eight a tenth. That they scatter by
// nothing is no reason to stop.
TEST(BlockEstimates, pixels_beside_another_brightness_may_have_missed_an_edge) {
  for (const int samples : {2, 8}) {
    auto block = even(samples);
    for (int s = 0; s < 8; ++s) block->add(20, Vec3f(0.8f));
    look(*block, static_cast<float>(samples));
    const double beside = static_cast<double>(block->mean[kLanes + 20]);
    const double error = code(0.2 + (beside - 0.2) / (samples + 2.0)) - code(0.2);
    const double scatter = 0.05 * std::pow(samples, 1.6) * error * error;
    const double expected = std::pow(scatter / (kError * kError), 1.0 / 2.6);
    EXPECT_GT(expected, samples == 2 ? 2.0 : 1.0);
    EXPECT_GT(static_cast<double>(block->wanted[36]), 0.99 * expected);  // two samples share the bright pixel's scatter, too
    EXPECT_LT(static_cast<double>(block->wanted[36]), samples == 2 ? kInfinity : 1.01 * expected);
    EXPECT_LT(block->wanted[35], 0.01f);
  }
}

TEST(BlockEstimates, the_frame_before_is_believed_where_it_says_more) {
  auto block = even(2);
  block->before[3] = 64.0f * kError * kError;
  look(*block, 2.0f);
  EXPECT_NEAR(block->wanted[3], std::pow(64.0f, 1.0f / 2.6f), 1e-2f);
  EXPECT_LT(block->wanted[4], 0.01f);
}

}  // namespace
}  // namespace lippmann

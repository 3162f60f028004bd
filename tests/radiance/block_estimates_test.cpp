// How many samples the pixels of a block should have, worked out by hand.
#include "radiance/block_estimates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/random.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kPixels = 40;  // two packets and a half
constexpr float kError = 0.01f, kAnyError = std::numeric_limits<float>::infinity();

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
  find_wanted(have, kError, kAnyError, block);
}

/// The code of sRGB's curve above its toe.
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

// Paths of pixel 7 differ, those of pixel 20 happen to agree, and of pixel 30 one sample of two was left to a path: all want
// samples for what these paths scatter together.
TEST(BlockEstimates, pixels_that_are_left_to_paths_want_what_all_of_these_scatter) {
  auto block = std::make_unique<BlockEstimates>();
  for (std::uint32_t e = 0; e < kPixels; ++e) {
    block->push_back(100 + e, 0.0f);
    const bool is_path = e == 7 || e == 20;
    block->add(e, Vec3f(e == 7 ? 0.21f : 0.2f), 0.0f, is_path || e == 30);
    block->add(e, Vec3f(e == 7 ? 0.19f : 0.2f), 0.0f, is_path);
  }
  encode(*block);
  PathScatter scatter;
  EXPECT_EQ(scatter.mean(), 0.0f);
  scatter.add(*block);
  const float of_seven = block->scatter[kLanes + 7];
  EXPECT_NEAR(scatter.mean(), of_seven / 2.5f, 1e-3f * of_seven);  // shares of 1, 1 and 1/2
  block->path_scatter = scatter.mean();
  find_wanted(2.0f, kError, kAnyError, *block);
  EXPECT_NEAR(block->wanted[20], std::sqrt(scatter.mean()) / kError, 1e-3f * block->wanted[20]);
  EXPECT_NEAR(block->wanted[30], std::sqrt(0.5f * scatter.mean()) / kError, 1e-3f * block->wanted[30]);
  EXPECT_LT(block->wanted[25], 0.01f);
}

// One of four samples is open: alpha scatters by 3/4 x 1/4 x 4/3. The light of all is the same.
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
  // The least that they scatter: without one of the brighter ones, with eight of 0.2.
  const double slope = 1.055 / 2.4 * std::pow(0.2, 1.0 / 2.4 - 1.0), mean = (8 * 0.2 + 3 * 0.23 + 4 * 0.17) / 15.0;
  const double square = (8 * 0.2 * 0.2 + 3 * 0.23 * 0.23 + 4 * 0.17 * 0.17) / 15.0;
  const double least = slope * slope * (square - mean * mean);
  const double expected = std::pow(least / (kError * kError), 1.0 / 2.6);
  EXPECT_GT(expected, 1.5);
  EXPECT_NEAR(static_cast<double>(block->wanted[20]), expected, 1e-3 * expected);
  EXPECT_LT(block->wanted[25], 0.01f);
}

/// What its neighbours scatter counts beside what a pixel scatters itself.
double share_of_neighbours(int samples) { return samples < 8 ? 1.0 : 64.0 / (samples + 64.0); }

// What a pixel's own samples scatter does not count while they are few; it counts for its neighbours along and across rays,
// a quarter for each, and still does when there are more.
TEST(BlockEstimates, neighbours_decide_until_a_pixel_has_eight_samples) {
  for (const int samples : {2, 8}) {
    auto block = even(samples);
    block->samples[20] = 0.0f, block->luminance[20] = block->square[20] = 0.0f;
    for (int s = 0; s < samples; ++s) block->add(20, Vec3f(s % 2 ? 0.201f : 0.199f));
    look(*block, static_cast<float>(samples));
    EXPECT_EQ(block->wanted[20] > 0.05f, samples == 8) << samples;
    const double around = share_of_neighbours(samples) * 0.25 * static_cast<double>(block->scatter[kLanes + 20]);
    const double expected = std::pow(around / (kError * kError), 1.0 / 2.6);
    for (const std::size_t e : {std::size_t{19}, std::size_t{21}, std::size_t{4}, std::size_t{36}}) {
      EXPECT_GT(block->wanted[e], 0.05f) << e << " of " << samples;
      if (e == 19 || e == 21) {
        EXPECT_NEAR(static_cast<double>(block->wanted[e]), expected, 1e-2 * expected) << e;
      }
    }
    for (const std::size_t e : {std::size_t{18}, std::size_t{5}, std::size_t{35}}) EXPECT_LT(block->wanted[e], 0.01f) << e;
  }
}

// A bright pixel beside grey ones: eight grey samples may have missed a tenth of it. That they scatter by nothing is no reason
// to stop.
TEST(BlockEstimates, pixels_beside_another_brightness_may_have_missed_an_edge) {
  auto block = even(8);
  for (int s = 0; s < 8; ++s) block->add(20, Vec3f(0.8f));
  look(*block, 8.0f);
  const double beside = static_cast<double>(block->mean[kLanes + 20]);
  const double error = code(0.2 + (beside - 0.2) / 10.0) - code(0.2);
  const double missed = (0.05 + 1.1 / 64.0) * std::pow(8.0, 1.6) * error * error;
  const double around = share_of_neighbours(8) * 0.25 * static_cast<double>(block->scatter[kLanes + 20]);
  EXPECT_GT(missed, 0.1 * around);
  const double expected = std::pow((missed + around) / (kError * kError), 1.0 / 2.6);
  EXPECT_NEAR(static_cast<double>(block->wanted[21]), expected, 0.01 * expected);
  EXPECT_LT(block->wanted[35], 0.01f);
}

// Two of four neighbours are so bright that the mean of all would be white, which no light that was missed makes brighter. As
// shown, it is 0.6: two samples may have missed a quarter of what is white whatever is added, or of what is 0.2.
TEST(BlockEstimates, pixels_beside_overexposed_ones_may_have_missed_an_edge) {
  auto block = even(0);
  for (std::size_t e = 0; e < kPixels; ++e)
    for (int s = 0; s < 2; ++s) block->add(e, Vec3f(e == 19 || e == 21 ? 14.0f : 0.2f));
  look(*block, 2.0f);
  const double brighter = 1.0 - code(0.6), darker = code(0.6) - code(0.5);
  const double missed = (0.05 + 1.1 / 4.0) * std::pow(2.0, 1.6) * (brighter * brighter + darker * darker);
  const double expected = std::pow(missed / (kError * kError), 1.0 / 2.6);
  EXPECT_NEAR(static_cast<double>(block->wanted[20]), expected, 0.01 * expected);
}

/// Three packets of 64 samples a pixel: dark below lane 5, bright above it, half of each in lane 5.
std::unique_ptr<BlockEstimates> edge_between(float dark, float bright) {
  auto block = std::make_unique<BlockEstimates>();
  for (std::uint32_t e = 0; e < 3 * kLanes; ++e) {
    block->push_back(e, 0.0f);
    const int lane = static_cast<int>(e) % kLanes;
    for (int s = 0; s < 64; ++s) block->add(e, Vec3f(lane < 5 || (lane == 5 && s % 2) ? dark : bright));
  }
  encode(*block);
  return block;
}

// What scatters by s^2 errs by s^2 / n^1.6 with n samples: half of 64 samples that are d brighter than the others, by d / 2.
// The mean of all pixels would want a sample or two.
TEST(BlockEstimates, no_edge_is_expected_to_err_by_more_than_the_worst_may) {
  constexpr float kCoarse = 0.5f, kWorst = 4e-5f;
  constexpr std::size_t kEdge = kLanes + 5;
  const auto slight = edge_between(0.2f, 0.22f), strong = edge_between(0.2f, 0.8f);
  for (BlockEstimates* block : {slight.get(), strong.get()}) {
    find_wanted(64.0f, kCoarse, kAnyError, *block);
    EXPECT_LT(block->wanted[kEdge], 2.0f);
    find_wanted(64.0f, kCoarse, kWorst, *block);
    EXPECT_LT(block->wanted[kLanes + 12], 0.1f);
  }
  // Its neighbours on both sides scatter by nothing, and count 64 samples of 128.
  const double step = code(0.22) - code(0.2), own = 0.25 * step * step;
  EXPECT_LT(slight->wanted[kEdge], std::pow(own / static_cast<double>(kWorst), 1.0 / 1.6));
  EXPECT_GT(slight->wanted[kEdge], std::pow(0.7 * own / static_cast<double>(kWorst), 1.0 / 1.6));
  EXPECT_NEAR(strong->wanted[kEdge], std::pow(kEdgeScatter / kWorst, 1.0f / 1.6f), 0.5f);  // 56
}

// Noise, however strong, is no edge: half of the samples of every pixel are bright.
TEST(BlockEstimates, noise_without_an_edge_may_err_by_more) {
  auto block = even(0);
  for (std::size_t e = 0; e < kPixels; ++e)
    for (int s = 0; s < 64; ++s) block->add(e, Vec3f(s % 2 ? 0.8f : 0.2f));
  encode(*block);
  find_wanted(64.0f, 0.5f, 4e-5f, *block);
  EXPECT_LT(block->wanted[20], 2.0f);
}

struct Sampled {
  double mean = 0.0, most = 0.0;  ///< the mean of the light; the most samples that a pixel gets
};

/// 400 blocks of 40 pixels that get as many samples as is found, from draw().
Sampled sample_blocks(float error, float worst, const auto& draw) {
  constexpr int kBlocks = 400;
  Sampled sampled;
  for (int b = 0; b < kBlocks; ++b) {
    auto block = even(0);
    for (std::size_t e = 0; e < kPixels; ++e)
      for (int s = 0; s < 2; ++s) block->add(e, Vec3f(draw()));
    for (float have = 2.0f; have < 64.0f; have *= 2.0f) {
      encode(*block);
      find_wanted(have, error, worst, *block);
      for (std::size_t e = 0; e < kPixels; ++e)
        if (block->samples[e] == have && block->wanted[e] > have)
          for (int s = 0; s < static_cast<int>(have); ++s) block->add(e, Vec3f(draw()));
    }
    for (std::size_t e = 0; e < kPixels; ++e) {
      sampled.mean += static_cast<double>(block->radiance(e).y) / (kBlocks * kPixels);
      sampled.most = std::max(sampled.most, static_cast<double>(block->samples[e]));
    }
  }
  return sampled;
}

/// Random numbers from 0 to 1, the same in every run.
auto random_numbers(std::uint32_t stream) {
  return [state = 1u, stream]() mutable {
    state = hash(state, stream);
    return unit_float(state);
  };
}

// One sample in twenty is bright, as where few choose the lamp that counts: whether a pixel has met it among its first eight
// must not decide how many more it gets. Deviation of a sample 0.21, of the mean of 8 of each below 0.0006.
TEST(BlockEstimates, light_that_few_samples_bring_is_not_lost) {
  for (const auto& [error, worst] : {std::pair(0.02f, kAnyError), std::pair(0.2f, 2e-4f)}) {
    auto random = random_numbers(9);
    const Sampled sampled = sample_blocks(error, worst, [&] { return random() < 0.05f ? 1.0f : 0.02f; });
    EXPECT_GT(sampled.most, 8.0);
    EXPECT_NEAR(sampled.mean, 0.069, 0.04 * 0.069) << error;
  }
}

// A bright thing that covers an eighth of every pixel of a row, sampled at random. The mean of all pixels is right whatever
// they are given: deviation of a sample 0.33; of n samples at least 2, that of the mean below 0.0019.
TEST(BlockEstimates, small_bright_things_lose_no_light) {
  for (const auto& [error, worst] : {std::pair(0.03f, kAnyError), std::pair(0.3f, 2e-3f)}) {
    auto random = random_numbers(7);
    const Sampled sampled = sample_blocks(error, worst, [&] { return random() < 0.125f ? 1.0f : 0.0f; });
    EXPECT_GT(sampled.most, 4.0);  // it was decided
    EXPECT_NEAR(sampled.mean, 0.125, 4.0 * 0.0019) << error;
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

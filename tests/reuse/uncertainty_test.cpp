#include "reuse/uncertainty.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

/// A single view of 16 x 8 pixels. Neighbours in the view are therefore also neighbours on the panel.
Optics small_view() {
  Optics optics;
  optics.panel = {16, 8, 1.0f};
  optics.model = SingleView{100.0f, {0.0f, 0.0f}};
  return optics;
}

constexpr std::size_t kWidth = 16, kPixels = 16 * 8;

std::size_t pixel(std::size_t x, std::size_t y) { return y * kWidth + x; }

/// Two key frames and the predicted film, all black at first. A code is 255 times a value. Each pixel has points from
/// both key frames.
struct Case {
  Image previous{16, 8, 3}, following{16, 8, 3}, film{16, 8, 3};
  SplatBuffer landed_previous{std::vector<std::uint64_t>(kPixels, 1)}, landed_following = landed_previous;

  static void paint(Image& image, std::size_t p, float value) {
    for (std::size_t c = 0; c < 3; ++c) image.data[3 * p + c] = value;
  }
  std::vector<std::uint8_t> uncertainty(int threads = 1) const {
    UncertaintyEstimator estimator(small_view(), Encoding::kTachyonTruncate);
    std::vector<std::uint8_t> result;
    estimator.estimate({previous, landed_previous}, {following, landed_following}, film, ThreadPool(threads), result);
    return result;
  }
};

TEST(Uncertainty, agreeing_flat_keys_have_none) { EXPECT_EQ(Case().uncertainty(), std::vector<std::uint8_t>(kPixels, 0)); }

TEST(Uncertainty, disagreement_spreads_to_neighbours) {
  Case c;
  Case::paint(c.following, pixel(5, 3), 40.0f / 255.0f);
  const auto uncertainty = c.uncertainty();
  // The pixel's own difference is 40. Half of the largest difference in its neighbourhood, which includes the pixel, is
  // 20.
  EXPECT_EQ(uncertainty[pixel(5, 3)], 40 + 20);
  // 40 / 2 as a neighbour in the view, and 40 / 2 as an adjacent pixel of the panel.
  EXPECT_EQ(uncertainty[pixel(6, 3)], 20 + 20);
  EXPECT_EQ(uncertainty[pixel(5, 4)], 20);
  EXPECT_EQ(uncertainty[pixel(4, 2)], 20);
  EXPECT_EQ(uncertainty[pixel(7, 3)], 0);
  EXPECT_EQ(uncertainty[pixel(5, 5)], 0);
}

TEST(Uncertainty, contrast_of_the_prediction_counts_an_eighth) {
  Case c;
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t x = 8; x < 16; ++x) Case::paint(c.film, pixel(x, y), 80.0f / 255.0f);
  const auto uncertainty = c.uncertainty();
  // A step of 80 codes counts by 1/8 between neighbours in a view, and by 1/8 between neighbours on the panel.
  EXPECT_EQ(uncertainty[pixel(7, 3)], 80 / 8 + 80 / 8);
  EXPECT_EQ(uncertainty[pixel(8, 3)], 80 / 8 + 80 / 8);
  EXPECT_EQ(uncertainty[pixel(6, 3)], 0);
  EXPECT_EQ(uncertainty[pixel(9, 3)], 0);
}

TEST(Uncertainty, pixels_with_few_points_are_uncertain) {
  Case c;
  c.landed_previous.keys[pixel(2, 2)] = 0;
  c.landed_following.keys[pixel(9, 2)] = 0;
  c.landed_previous.keys[pixel(5, 6)] = c.landed_following.keys[pixel(5, 6)] = 0;
  const auto uncertainty = c.uncertainty();
  EXPECT_EQ(uncertainty[pixel(2, 2)], kOneKeyUncertainty);
  EXPECT_EQ(uncertainty[pixel(9, 2)], kOneKeyUncertainty);
  EXPECT_EQ(uncertainty[pixel(5, 6)], kMissedUncertainty);
  EXPECT_EQ(uncertainty[pixel(3, 2)], 0);
}

TEST(Uncertainty, linear_film_is_compared_by_square_roots) {
  Case c;
  Case::paint(c.following, pixel(5, 3), 0.25f);
  UncertaintyEstimator estimator(small_view(), Encoding::kSrgb);
  std::vector<std::uint8_t> uncertainty;
  estimator.estimate({c.previous, c.landed_previous}, {c.following, c.landed_following}, c.film, ThreadPool(1), uncertainty);
  EXPECT_EQ(uncertainty[pixel(5, 4)], 128 / 2);
}

TEST(Uncertainty, lenses_separate_neighbours_and_views) {
  Optics optics;
  optics.panel = {16, 8, 0.25f};
  LenticularSheet sheet;
  sheet.lens_pitch_mm = 1.0f;
  sheet.gap_mm = 2.0f;
  optics.model = sheet;
  Case c;
  Case::paint(c.following, pixel(5, 3), 40.0f / 255.0f);
  UncertaintyEstimator estimator(optics, Encoding::kTachyonTruncate);
  std::vector<std::uint8_t> uncertainty;
  estimator.estimate({c.previous, c.landed_previous}, {c.following, c.landed_following}, c.film, ThreadPool(1), uncertainty);
  EXPECT_EQ(uncertainty[pixel(9, 3)], 20);  // same view, next lens
  EXPECT_EQ(uncertainty[pixel(1, 4)], 20);
  EXPECT_EQ(uncertainty[pixel(6, 3)], 20);  // same lens, next view
  EXPECT_EQ(uncertainty[pixel(7, 3)], 0);
  EXPECT_EQ(uncertainty[pixel(6, 4)], 0);
}

}  // namespace
}  // namespace lippmann

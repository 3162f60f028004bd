// Which pixels of a frame are measured, and what is found of its error on them.
#include "radiance/pixel_error.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/random.hpp"
#include "lippmann/image/encode.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

/// Black on the left, white on the right.
Image with_edge(int size) {
  Image film(size, size, 3);
  for (int y = 0; y < size; ++y)
    for (int x = size / 2; x < size; ++x)
      for (std::size_t c = 0; c < 3; ++c) film.data[3 * static_cast<std::size_t>(y * size + x) + c] = 1.0f;
  return film;
}

TEST(MeasuredPixels, are_spread_evenly_where_nothing_is_known) {
  const MeasuredPixels chosen = choose_pixels(Image(64, 64, 3), {1000, 16, 100}, {}, 7);
  ASSERT_EQ(chosen.pixels.size(), 256u);
  for (std::size_t i = 0; i < 256; ++i) {
    EXPECT_EQ(chosen.pixels[i] / 16, i) << "one of every 16";
    EXPECT_DOUBLE_EQ(chosen.weights[i], 1.0);
  }
}

TEST(MeasuredPixels, are_as_many_as_are_enough_but_neither_few_nor_a_small_part_of_a_large_frame) {
  const auto count = [](int size, const MeasuredShare& share) {
    return choose_pixels(Image(size, size, 3), share, {}, 7).pixels.size();
  };
  EXPECT_EQ(count(8, {1000, 16, 100}), 64u) << "there are no more";
  // A pixel may stand for two parts, where these end within it.
  EXPECT_NEAR(static_cast<double>(count(32, {1000, 16, 100})), 192.0, 2.0);
  EXPECT_NEAR(static_cast<double>(count(256, {1000, 16, 100})), 1000.0, 2.0);
  EXPECT_NEAR(static_cast<double>(count(512, {1000, 16, 100})), 2621.0, 2.0);
}

// Two of 64 columns lie on the edge: with 0.5 of even chance for all, 1 + 64 / 2 / 0.5 times as many of their pixels are
// chosen.
TEST(MeasuredPixels, are_more_at_edges_and_weigh_as_much_less) {
  const Image film = with_edge(64);
  const MeasuredPixels chosen = choose_pixels(film, {1000, 8, 100}, {}, 7);
  double at_edge = 0.0, all = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < chosen.pixels.size(); ++i) {
    const std::uint32_t x = chosen.pixels[i] % 64;
    all += chosen.weights[i];
    if (x != 31 && x != 32) continue;
    at_edge += chosen.weights[i], ++count;
  }
  EXPECT_GT(count, 100) << "of 128, where 16 would be their share";
  EXPECT_NEAR(at_edge / all, 2.0 / 64.0, 0.004);
}

TEST(MeasuredPixels, are_more_where_samples_scattered) {
  Scatter scatter(64 * 64, 0.0f);
  std::fill_n(scatter.begin(), 64 * 8, 0.04f);
  const MeasuredPixels chosen = choose_pixels(Image(64, 64, 3), {1000, 16, 100}, scatter, 7);
  const auto above = std::count_if(chosen.pixels.begin(), chosen.pixels.end(), [](std::uint32_t p) { return p < 64 * 8; });
  EXPECT_GT(above, 160);  // 256 are chosen, and 32 would be their share
}

/// A matt floor below a sky, by paths.
class SkyPixels : public testing::Test {
 protected:
  SkyPixels() : s_(scene()), device_(s_.scene, pool_, Integrator::kPath) {
    device_.update(evaluate(s_.scene, 0.0), pool_);
    params_.max_depth = 3, params_.spp = 16;
  }

  Image traced(int spp, std::uint32_t seed) const {
    TraceParams params = params_;
    params.spp = spp, params.seed = seed;
    Image film;
    trace_frame({device_, optics_, {}}, params, {pool_, context_}, {film});
    return film;
  }

  PixelMeasure measure(const Image& film, int sets) const {
    return {{device_, optics_, {}}, params_, choose_pixels(film, {1u << 20, 1, 1}, {}, 7), sets, {pool_, context_}};
  }

 private:
  static SmallScene scene() {
    SmallScene s;
    s.scene.background.horizon = {0.9f, 0.6f, 0.3f};
    s.scene.background.zenith = {0.1f, 0.2f, 0.6f};
    s.add(Boxes{{{-4.0f, -1.2f, -4.0f}, {4.0f, -1.0f, 4.0f}}, {{-4.0f, -4.0f, -4.0f}, {4.0f, 4.0f, -3.0f}}},
          s.material(matte(Vec3f(0.5f))));
    return s;
  }

  ThreadPool pool_{2};
  Context context_;
  SmallScene s_;
  Optics optics_ = single_view(64);
  DeviceScene device_;
  TraceParams params_;
};

TEST_F(SkyPixels, a_picture_that_is_wrong_by_ten_codes_errs_by_their_square) {
  Image film = traced(1024, 3);
  const PixelMeasure measure = this->measure(film, 2);
  const PixelError converged = measure.error_of(film);
  EXPECT_LT(std::abs(converged.squared), 4.0f * converged.uncertainty + 1e-6f);
  constexpr float kStep = 10.0f / 255.0f;
  for (float& v : film.data) v = static_cast<float>(linear_from_srgb(srgb_from_linear(v) + kStep));
  const PixelError off = measure.error_of(film);
  EXPECT_NEAR(off.squared, kStep * kStep, 4.0f * off.uncertainty + 0.02f * kStep * kStep);
  EXPECT_LT(off.uncertainty, 0.1f * kStep * kStep);
}

// By two sets that have nothing to do with the picture, by one and the picture, and as an error like any other.
TEST_F(SkyPixels, paths_err_by_the_same_whichever_way_it_is_measured) {
  const Image film = traced(16, 3);
  const PixelMeasure two = measure(film, 2), one = measure(film, 1);
  const PixelError by_sets = two.of_paths(), by_film = one.of_paths(film), as_any = two.error_of(film);
  EXPECT_GT(by_sets.squared, 1e-5f);
  EXPECT_NEAR(by_film.squared, by_sets.squared, 4.0f * std::hypot(by_film.uncertainty, by_sets.uncertainty));
  EXPECT_NEAR(as_any.squared, by_sets.squared, 4.0f * std::hypot(as_any.uncertainty, by_sets.uncertainty));
  EXPECT_LT(by_film.uncertainty, 0.1f * by_film.squared);
}

}  // namespace
}  // namespace lippmann

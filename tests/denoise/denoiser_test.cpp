// Frames of four views of 24 x 16 pixels, which show a plane at z = 0 unless stated otherwise.
#include "denoise/denoiser.hpp"

#include <gtest/gtest.h>

#include <random>

namespace lippmann {
namespace {

constexpr int kWidth = 96, kHeight = 16;

Optics four_views() {
  return {{kWidth, kHeight, 0.25f}, MultiView{.columns = 4, .rows = 1, .view_cone = 0.4f, .distance_mm = 60.0f}};
}

struct Made {
  Image film{kWidth, kHeight, 3}, noise{kWidth, kHeight, 3}, seen{kWidth, kHeight, 3}, albedo{kWidth, kHeight, 3},
      normal{kWidth, kHeight, 3}, z{kWidth, kHeight, 1}, met{kWidth, kHeight, 1};

  Made() {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < 3; ++c) albedo.pixel(x, y)[c] = 0.5f;
        normal.pixel(x, y)[2] = 1.0f;
        met.pixel(x, y)[0] = 1.0f;
        set(x, y, 1.0f, 1.0f);
      }
  }

  /// Sets a pixel from the means of the two halves of its samples. `noise` is 0.5 sqrt(2) = 0.7 times their difference,
  /// because stratified halves differ sqrt(2) times as much as independent ones.
  void set(int x, int y, float even, float odd_half) {
    for (int c = 0; c < 3; ++c) {
      film.pixel(x, y)[c] = 0.5f * (even + odd_half);
      noise.pixel(x, y)[c] = 0.7f * (even - odd_half);
    }
  }

  DenoiserInput input() { return {film, noise, seen, albedo, normal, z, met}; }
};

Image denoised(Made made, int threads = 2) {
  const ThreadPool pool(threads);
  return Denoiser(four_views()).denoise(made.input(), pool);
}

Made noisy(unsigned seed) {
  Made made;
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(1.0f, 0.5f);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float even = noise(random), odd_half = noise(random);
      made.set(x, y, even, odd_half);
    }
  return made;
}

double mean_squared_error(const Image& film, float truth) {
  double sum = 0.0;
  for (const float v : film.data) sum += std::pow(static_cast<double>(v - truth), 2.0);
  return sum / static_cast<double>(film.data.size());
}

// A pixel has the squared error 0.5^2 / 2 = 0.125, and the mean of n pixels has 0.125 / n. The filter averages up to 17
// x 16 = 272 pixels. The limit is the error for n = 50, which leaves a margin.
TEST(Denoiser, noise_decreases_and_the_mean_stays) {
  const Made made = noisy(1);
  EXPECT_NEAR(mean_squared_error(made.film, 1.0f), 0.125, 0.02);
  const Image film = denoised(made);
  EXPECT_LT(mean_squared_error(film, 1.0f), 0.125 / 50);
  double sum = 0.0;
  for (const float v : film.data) sum += static_cast<double>(v);
  EXPECT_NEAR(sum / static_cast<double>(film.data.size()), 1.0, 3.0 * 0.35 / std::sqrt(kWidth * kHeight));
}

TEST(Denoiser, noise_free_light_keeps_its_shadows) {
  Made made;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (x % 24 < 12) made.set(x, y, 0.2f, 0.2f);
  const Image film = denoised(made);
  for (std::size_t i = 0; i < film.data.size(); ++i) ASSERT_NEAR(film.data[i], made.film.data[i], 1e-3f) << i;
}

// A difference of 2 % is so small that the filter averages the values. find_blur() must undo this blur.
TEST(Denoiser, slight_differences_without_noise_are_not_blurred) {
  Made made;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (x % 4 < 2) made.set(x, y, 1.02f, 1.02f);
  const Image film = denoised(made);
  for (std::size_t i = 0; i < film.data.size(); ++i) ASSERT_NEAR(film.data[i], made.film.data[i], 1e-4f) << i;
}

float farthest_from_one(const Image& film, int x, int away) {
  float farthest = 0.0f;
  for (int j = 0; j < kHeight; ++j)
    for (int i = 0; i < kWidth; ++i)
      if (std::abs(i - x) > away) farthest = std::max(farthest, std::abs(film.pixel(i, j)[0] - 1.0f));
  return farthest;
}

TEST(Denoiser, fireflies_leave_neither_dot_nor_blotch) {
  Made made;
  made.set(36, 8, 41.0f, 1.0f);
  EXPECT_LT(farthest_from_one(denoised(made), 0, -1), 0.01f);
}

TEST(Denoiser, a_bright_pixel_without_noise_stays) {
  Made made;
  made.set(36, 8, 21.0f, 21.0f);
  EXPECT_NEAR(denoised(made).pixel(36, 8)[0], 21.0f, 0.1f);
}

TEST(Denoiser, an_isolated_bright_surface_stays) {
  Made made;
  made.set(36, 8, 41.0f, 1.0f);
  made.normal.pixel(36, 8)[0] = 1.0f, made.normal.pixel(36, 8)[2] = 0.0f;
  EXPECT_GT(denoised(made).pixel(36, 8)[0], 10.0f);
}

TEST(Denoiser, highlights_do_not_spread_into_their_surroundings) {
  Made made;
  for (int j = 7; j <= 9; ++j)
    for (int i = 35; i <= 37; ++i) made.set(i, j, (i + j) % 2 == 0 ? 80.0f : 1.0f, (i + j) % 2 == 0 ? 1.0f : 80.0f);
  const Image film = denoised(made);
  EXPECT_GT(film.pixel(36, 8)[0], 10.0f);
  EXPECT_LT(farthest_from_one(film, 36, 5), 0.05f);
}

TEST(Denoiser, textures_stay_sharp_under_noisy_light) {
  Made made = noisy(2);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; x += 2)
      for (int c = 0; c < 3; ++c) {
        made.albedo.pixel(x, y)[c] = 0.25f;
        made.film.pixel(x, y)[c] *= 0.5f, made.noise.pixel(x, y)[c] *= 0.5f;
      }
  const Image film = denoised(made);
  double dark = 0.0, bright = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; x += 2)
      dark += static_cast<double>(film.pixel(x, y)[0]), bright += static_cast<double>(film.pixel(x + 1, y)[0]);
  EXPECT_NEAR(dark / bright, 0.5, 0.05);
  EXPECT_NEAR(bright / (kWidth * kHeight / 2), 1.0, 0.05);
}

TEST(Denoiser, surfaces_with_different_normals_do_not_mix) {
  Made made = noisy(3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (x % 24 >= 12) {
        made.normal.pixel(x, y)[0] = 1.0f, made.normal.pixel(x, y)[2] = 0.0f;
        made.set(x, y, 1.5f, 1.5f);
      }
  const Image film = denoised(made);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      if (x % 24 < 12) continue;
      ASSERT_NEAR(film.pixel(x, y)[0], 1.5f, 1e-4f) << x << ", " << y;
    }
}

TEST(Denoiser, pixels_without_a_surface_do_not_change) {
  Made made = noisy(4);
  for (int x = 0; x < kWidth; ++x)
    for (int c = 0; c < 3; ++c) {
      made.met.pixel(x, 5)[0] = made.albedo.pixel(x, 5)[c] = made.normal.pixel(x, 5)[c] = 0.0f;
      made.seen.pixel(x, 5)[c] = made.film.pixel(x, 5)[c] = 0.01f * static_cast<float>(x);
    }
  const Image film = denoised(made);
  for (int x = 0; x < kWidth; ++x) EXPECT_EQ(film.pixel(x, 5)[0], 0.01f * static_cast<float>(x));
}

TEST(Denoiser, bits_do_not_depend_on_threads) {
  const Made made = noisy(6);
  EXPECT_EQ(denoised(made, 1).data, denoised(made, 3).data);
}

}  // namespace
}  // namespace lippmann

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "denoise/denoiser.hpp"
#include "kinds.hpp"

namespace lippmann {
namespace {

struct Plane {
  float z, light;
};

struct Frame {
  Image film, noise, seen, albedo, normal, z, met, truth;
};

/// The two halves of a pixel's samples have a standard deviation of 0.5 times the light. `noise` is 0.7 times their
/// difference, for the reason given at set() in denoiser_test.cpp.
Frame noisy_frame(const Optics& optics, const std::function<Plane(Vec2f place)>& plane_at) {
  const Vec2i size = film_size(optics);
  const Image three(size.x, size.y, 3), one(size.x, size.y, 1);
  Frame frame{three, three, three, three, three, one, one, one};
  std::mt19937 random(7);
  std::normal_distribution<float> gaussian;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const Ray ray = ray_of_pixel(optics, Vec2f(x, y) + 0.5f);
      const Plane plane = plane_at(Vec2f(ray.origin - ray.direction * (ray.origin.z / ray.direction.z)));
      frame.z.pixel(x, y)[0] = plane.z, frame.met.pixel(x, y)[0] = 1.0f, frame.truth.pixel(x, y)[0] = plane.light;
      frame.normal.pixel(x, y)[2] = 1.0f;
      for (int c = 0; c < 3; ++c) {
        const float even = plane.light * (1.0f + 0.5f * gaussian(random)), odd = plane.light * (1.0f + 0.5f * gaussian(random));
        frame.albedo.pixel(x, y)[c] = 0.5f;
        frame.film.pixel(x, y)[c] = 0.5f * (even + odd), frame.noise.pixel(x, y)[c] = 0.7f * (even - odd);
      }
    }
  return frame;
}

Image denoised(const Optics& optics, Frame frame, int threads = 2) {
  const ThreadPool pool(threads);
  return Denoiser(optics).denoise({frame.film, frame.noise, frame.seen, frame.albedo, frame.normal, frame.z, frame.met}, pool);
}

struct Errors {
  double squared = 0.0, mean = 0.0;
};

Errors errors_of(const Image& film, const Image& truth, int channel) {
  Errors errors;
  for (std::size_t p = 0; p < truth.data.size(); ++p) {
    const double light = truth.data[p], ratio = film.data[3 * p + static_cast<std::size_t>(channel)] / light;
    errors.squared += (ratio - 1.0) * (ratio - 1.0), errors.mean += ratio;
  }
  const auto pixels = static_cast<double>(truth.data.size());
  return {errors.squared / pixels, errors.mean / pixels};
}

/// Variance of a pixel, relative to the squared light. The pixel is the mean of two halves with the standard deviation 0.5, so
/// the variance is 0.5^2 / 2.
constexpr double kVariance = 0.125;

/// Fraction of the variance that may be left. A filter with the weights (1, 4, 6, 4, 1) / 16 leaves the sum of the squared
/// weights, 70 / 256, per direction. The factor 2 allows for narrow views.
constexpr double kLeft = 2.0 * (70.0 / 256.0) * (70.0 / 256.0);

TEST(DenoisedOptics, uniform_light_loses_only_its_noise) {
  for (const OpticsCase& kind : optics_cases())
    for (const float z : {-3.0f, 0.0f, 2.0f}) {
      const Frame frame = noisy_frame(kind.optics, [z](Vec2f) { return Plane{z, 1.0f}; });
      const Image film = denoised(kind.optics, frame);
      const double pixels = static_cast<double>(frame.truth.data.size());
      for (int c = 0; c < 3; ++c) {
        const Errors errors = errors_of(film, frame.truth, c);
        EXPECT_LT(errors.squared, kLeft * kVariance) << kind.name << " " << z;
        EXPECT_NEAR(errors.mean, 1.0, 4.0 * std::sqrt(kVariance / pixels)) << kind.name << " " << z;
      }
    }
}

TEST(DenoisedOptics, light_does_not_cross_edges_in_depth) {
  for (const OpticsCase& kind : optics_cases()) {
    const float width = window_size_mm(kind.optics).x / 8.0f;
    const Frame frame = noisy_frame(kind.optics, [width](Vec2f place) {
      return place.x < 0.0f ? Plane{-3.0f, 8.0f} : Plane{1.5f, place.x < width ? 1.0f : 1.001f};
    });
    const Image film = denoised(kind.optics, frame);
    double sum = 0.0;
    int pixels = 0;
    for (std::size_t p = 0; p < frame.truth.data.size(); ++p)
      if (frame.truth.data[p] == 1.0f) sum += static_cast<double>(film.data[3 * p]), ++pixels;
    EXPECT_NEAR(sum / pixels, 1.0, 4.0 * std::sqrt(kVariance / pixels)) << kind.name << " " << pixels;
    for (int c = 0; c < 3; ++c) EXPECT_LT(errors_of(film, frame.truth, c).squared, kLeft * kVariance) << kind.name;
  }
}

Plane tilted(Vec2f place) { return {0.2f * place.x, 1.0f + 0.02f * place.y}; }

Image rows_of(const Image& image, int first, int end) {
  Image rows(image.width, end - first, image.channels);
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(image.width) * image.channels;
  std::copy(image.data.begin() + first * row, image.data.begin() + end * row, rows.data.begin());
  return rows;
}

TEST(DenoisedOptics, strips_with_rows_around_match_the_film) {
  for (const OpticsCase& kind : optics_cases(4)) {
    const Optics& optics = kind.optics;
    const int height = film_size(optics).y, around = Denoiser::rows_around(optics);
    const int first = height / 2, end = first + 5, low = std::max(0, first - around), high = std::min(height, end + around);
    const auto tiles = view_tiles(optics);
    EXPECT_EQ(high - low == height, tiles && tiles->rows > 1) << kind.name;
    const Frame frame = noisy_frame(optics, tilted);
    Frame strip;
    for (Image Frame::*image :
         {&Frame::film, &Frame::noise, &Frame::seen, &Frame::albedo, &Frame::normal, &Frame::z, &Frame::met})
      strip.*image = rows_of(frame.*image, low, high);
    const ThreadPool pool(2);
    const Image film =
        Denoiser(optics, low, high)
            .denoise({strip.film, strip.noise, strip.seen, strip.albedo, strip.normal, strip.z, strip.met}, pool);
    EXPECT_EQ(rows_of(film, first - low, end - low).data, rows_of(denoised(optics, frame), first, end).data) << kind.name;
  }
}

TEST(DenoisedOptics, huge_light_and_depths_stay_finite) {
  for (const OpticsCase& kind : optics_cases()) {
    Frame frame = noisy_frame(kind.optics, [](Vec2f place) { return place.x < 0.0f ? Plane{-1e30f, 1e30f} : tilted(place); });
    frame.film.data[0] = 3e38f, frame.noise.data[0] = -3e38f;
    frame.normal.data[2] = frame.albedo.data[0] = 0.0f;
    const Image film = denoised(kind.optics, frame);
    EXPECT_TRUE(std::all_of(film.data.begin(), film.data.end(), [](float v) { return std::isfinite(v); })) << kind.name;
  }
}

TEST(DenoisedOptics, views_of_a_single_pixel_are_denoised) {
  const Optics optics{{16, 16, 0.25f}, MicrolensArray{.lens_pitch_mm = 4.0f, .gap_mm = 8.0f, .offset_mm = {0.0f, 0.0f}}};
  const Frame frame = noisy_frame(optics, [](Vec2f) { return Plane{0.0f, 1.0f}; });
  EXPECT_LT(errors_of(denoised(optics, frame), frame.truth, 0).squared, kVariance);
}

TEST(DenoisedOptics, bits_do_not_depend_on_threads) {
  for (const OpticsCase& kind : optics_cases()) {
    const Frame frame = noisy_frame(kind.optics, tilted);
    EXPECT_EQ(denoised(kind.optics, frame, 1).data, denoised(kind.optics, frame, 3).data) << kind.name;
  }
}

}  // namespace
}  // namespace lippmann

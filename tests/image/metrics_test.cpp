#include "lippmann/image/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "image/flip.hpp"
#include "image/ms_ssim.hpp"
#include "image/png.hpp"
#include "image/ssim.hpp"
#include "lippmann/core/error.hpp"
#include "support/command.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::noise_codes;
using test::smooth_codes;

Image8 flat(int width, int height, unsigned char code) {
  return {width, height, std::vector<unsigned char>(std::size_t{3} * width * height, code)};
}

/// SSIM by its definition, with a two-dimensional window and variances about the local mean.
double ssim_by_definition(const Image8& a, const Image8& b) {
  const auto luma = [](const Image8& image, int x, int y) {
    const unsigned char* p = &image.rgb[3 * (std::size_t(y) * image.width + x)];
    return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
  };
  double total = 0.0, norm = 0.0;
  for (int j = -5; j <= 5; ++j)
    for (int i = -5; i <= 5; ++i) norm += std::exp(-(i * i + j * j) / 4.5);
  int places = 0;
  for (int y = 5; y < a.height - 5; ++y)
    for (int x = 5; x < a.width - 5; ++x, ++places) {
      double mu_a = 0, mu_b = 0, var_a = 0, var_b = 0, cov = 0;
      for (int pass = 0; pass < 2; ++pass)
        for (int j = -5; j <= 5; ++j)
          for (int i = -5; i <= 5; ++i) {
            const double w = std::exp(-(i * i + j * j) / 4.5) / norm, p = luma(a, x + i, y + j), q = luma(b, x + i, y + j);
            if (pass == 0) {
              mu_a += w * p, mu_b += w * q;
            } else {
              var_a += w * (p - mu_a) * (p - mu_a), var_b += w * (q - mu_b) * (q - mu_b), cov += w * (p - mu_a) * (q - mu_b);
            }
          }
      total +=
          (2 * mu_a * mu_b + 6.5025) * (2 * cov + 58.5225) / ((mu_a * mu_a + mu_b * mu_b + 6.5025) * (var_a + var_b + 58.5225));
    }
  return total / places;
}

TEST(Metrics, errors_are_worked_out_by_hand) {
  const Image8 reference{2, 1, {10, 20, 30, 40, 50, 60}}, test{2, 1, {13, 20, 26, 36, 50, 68}};
  const PictureMetrics m = measure_difference(reference, test);
  EXPECT_DOUBLE_EQ(m.mse.r, (9.0 + 16.0) / 2.0);
  EXPECT_DOUBLE_EQ(m.mse.g, 0.0);
  EXPECT_DOUBLE_EQ(m.mse.b, (16.0 + 64.0) / 2.0);
  EXPECT_DOUBLE_EQ(m.mse.mean, 17.5);
  EXPECT_DOUBLE_EQ(m.rmse.b, std::sqrt(40.0));
  EXPECT_DOUBLE_EQ(m.rmse.mean, std::sqrt(17.5));
  EXPECT_NEAR(m.psnr_db, 35.70042, 1e-5);  // 10 log10(255^2 / MSE) dB with the mean squared error 17.5
  EXPECT_FALSE(m.identical);
}

TEST(Metrics, psnr_matches_the_papers_table_1) { EXPECT_NEAR(psnr_db(21.4394), 34.8187, 5e-5); }

TEST(Metrics, invalid_pairs_of_pictures_are_refused) {
  Image8 short_of_samples = flat(16, 16, 0);
  short_of_samples.rgb.resize(30);
  EXPECT_THROW(measure_difference(flat(16, 16, 0), flat(16, 8, 0)), Error);
  EXPECT_THROW(measure_difference(flat(16, 16, 0), short_of_samples), Error);
  EXPECT_THROW(measure_difference(Image8{}, Image8{}), Error);
}

TEST(Metrics, black_against_white_is_0_db) { EXPECT_EQ(measure_difference(flat(16, 16, 0), flat(16, 16, 255)).psnr_db, 0.0); }

TEST(Metrics, equal_pictures_are_identical) {
  const PictureMetrics m = measure_difference(noise_codes(20, 20), noise_codes(20, 20));
  EXPECT_TRUE(m.identical);
  EXPECT_EQ(m.mse.mean, 0.0);
  EXPECT_EQ(m.psnr_db, std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(m.ssim, 1.0);
}

TEST(Metrics, rmse_equals_ffmpegs_psnr_filter) {
  if (!test::program_exists("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  const test::TempDir dir;
  const Image8 a = smooth_codes(64, 48), b = smooth_codes(64, 48, 0.1);
  write_png(dir / "a.png", a);
  write_png(dir / "b.png", b);
  const std::string output = test::run_command("ffmpeg -nostats -i '" + (dir / "a.png").string() + "' -i '" +
                                               (dir / "b.png").string() + "' -lavfi '[0][1]psnr' -f null -")
                                 .output;
  const PictureMetrics m = measure_difference(a, b);
  for (const auto& [label, rmse] : {std::pair("PSNR r:", m.rmse.r), {" g:", m.rmse.g}, {" b:", m.rmse.b}}) {
    const double filtered = 255.0 * std::pow(10.0, -test::number_after(output, label) / 20.0);
    EXPECT_NEAR(rmse, filtered, 1e-6 * filtered) << label << " is printed with 6 decimals of a decibel: 6e-8 of the RMSE";
  }
}

TEST(Metrics, luma_and_chroma_match_hand_results) {
  const PictureMetrics m = measure_difference(flat(4, 4, 100), flat(4, 4, 110));
  EXPECT_NEAR(m.psnr_y_db, 10.0 * std::log10(65025.0 / 100.0), 1e-12) << "grey differs in luma alone";
  EXPECT_EQ(m.psnr_yuv_db, std::numeric_limits<double>::infinity());
  const PictureMetrics red = measure_difference(Image8{1, 1, {100, 0, 0}}, Image8{1, 1, {110, 0, 0}});
  const double y = 2.126, u = -2.126 / 1.8556, v = 7.874 / 1.5748;
  EXPECT_NEAR(red.psnr_y_db, psnr_db(y * y), 1e-12);
  EXPECT_NEAR(red.psnr_yuv_db, (6.0 * psnr_db(y * y) + psnr_db(u * u) + psnr_db(v * v)) / 8.0, 1e-12);
}

TEST(Metrics, luma_psnr_equals_ffmpegs_psnr_filter) {
  if (!test::program_exists("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  const test::TempDir dir;
  const Image8 a = smooth_codes(64, 48), b = smooth_codes(64, 48, 0.1);
  write_png(dir / "a.png", a);
  write_png(dir / "b.png", b);
  const std::string to_yuv = "scale=out_color_matrix=bt709:out_range=pc:flags=accurate_rnd+full_chroma_int,format=yuv444p16le";
  const std::string output =
      test::run_command("ffmpeg -nostats -i '" + (dir / "a.png").string() + "' -i '" + (dir / "b.png").string() +
                        "' -lavfi '[0]" + to_yuv + "[a];[1]" + to_yuv + "[b];[a][b]psnr' -f null -")
          .output;
  const PictureMetrics m = measure_difference(a, b);
  const double y = test::number_after(output, "PSNR y:"), u = test::number_after(output, " u:"),
               v = test::number_after(output, " v:");
  // ffmpeg converts code c to 256 c in 16 bits, but uses a peak of 65535 instead of 256 * 255.
  const double peak_db = 20.0 * std::log10(65535.0 / (256.0 * 255.0));
  EXPECT_NEAR(m.psnr_y_db + peak_db, y, 0.005);
  EXPECT_NEAR(m.psnr_yuv_db + peak_db, (6.0 * y + u + v) / 8.0, 0.005);
}

TEST(Metrics, slow_metrics_are_computed_on_request) {
  const Image8 a = smooth_codes(170, 165), b = smooth_codes(170, 165, 0.3);
  EXPECT_FALSE(measure_difference(a, b).flip || measure_difference(a, b).ms_ssim);
  const PictureMetrics m = measure_difference(a, b, {.ms_ssim = true, .flip = true});
  EXPECT_EQ(m.flip, flip(a, b));
  EXPECT_EQ(m.ms_ssim, ms_ssim(a, b));
}

TEST(Flip, is_largest_for_primaries) {
  const Image8 a = noise_codes(30, 20);
  EXPECT_EQ(flip(a, a), 0.0);
  Image8 green = flat(40, 40, 0), blue = green;
  for (std::size_t i = 0; i < green.rgb.size(); i += 3) green.rgb[i + 1] = blue.rgb[i + 2] = 255;
  EXPECT_NEAR(flip(green, blue), 1.0, 1e-6) << "the paper's largest difference";
}

TEST(MsSsim, needs_a_window_at_the_fifth_scale) {
  EXPECT_TRUE(std::isnan(ms_ssim(flat(160, 200, 5), flat(160, 200, 5))));
  EXPECT_DOUBLE_EQ(ms_ssim(noise_codes(161, 161), noise_codes(161, 161)), 1.0);
}

TEST(MsSsim, flat_pictures_keep_the_coarsest_luminance_term) {
  const double luminance = (2.0 * 100 * 120 + 6.5025) / (100.0 * 100 + 120.0 * 120 + 6.5025);
  EXPECT_NEAR(ms_ssim(flat(170, 170, 100), flat(170, 170, 120)), std::pow(luminance, 0.1333), 1e-9);
}

TEST(Ssim, flat_pictures_keep_only_the_luminance_term) {
  const double expected = (2.0 * 100 * 120 + 6.5025) / (100.0 * 100 + 120.0 * 120 + 6.5025);
  EXPECT_NEAR(ssim(flat(30, 20, 100), flat(30, 20, 120)), expected, 1e-9);
}

TEST(Ssim, equals_the_two_dimensional_definition) {
  const Image8 a = smooth_codes(37, 23), b = noise_codes(37, 23), c = smooth_codes(37, 23, 0.4);
  EXPECT_NEAR(ssim(a, b), ssim_by_definition(a, b), 1e-9) << "sums of squares up to 2.5e5 in double";
  EXPECT_NEAR(ssim(a, c), ssim_by_definition(a, c), 1e-9);
}

TEST(Ssim, is_symmetric) {
  const Image8 a = smooth_codes(40, 30), b = noise_codes(40, 30);
  EXPECT_DOUBLE_EQ(ssim(a, b), ssim(b, a));
}

TEST(Ssim, too_small_picture_gives_nan) {
  EXPECT_TRUE(std::isnan(ssim(flat(10, 30, 5), flat(10, 30, 5))));
  EXPECT_FALSE(std::isnan(ssim(flat(11, 11, 5), flat(11, 11, 5))));
}

}  // namespace
}  // namespace lippmann

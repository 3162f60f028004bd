#include "lippmann/image/metrics.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "image/flip.hpp"
#include "image/ms_ssim.hpp"
#include "image/require_samples.hpp"
#include "image/ssim.hpp"
#include "image/yuv_error.hpp"

namespace lippmann {
namespace {

/// The sums are exact: 2^28 pixels, the limit, add up to at most 2^28 * 255^2, which fits into 64 bits.
std::array<std::uint64_t, 3> squared_differences(const Image8& a, const Image8& b) {
  std::array<std::uint64_t, 3> sums{};
  for (std::size_t i = 0; i < a.rgb.size(); i += 3)
    for (int c = 0; c < 3; ++c) {
      const int d = int{a.rgb[i + c]} - int{b.rgb[i + c]};
      sums[c] += static_cast<std::uint64_t>(d * d);
    }
  return sums;
}

}  // namespace

double psnr_db(double mean_mse) {
  return mean_mse > 0.0 ? 10.0 * std::log10(255.0 * 255.0 / mean_mse) : std::numeric_limits<double>::infinity();
}

PictureMetrics measure_difference(const Image8& reference, const Image8& test, const SlowMetrics& wanted) {
  require_samples(reference, "reference");
  require_samples(test, "test");
  if (reference.width != test.width || reference.height != test.height)
    throw Error("test", fmt::format("has {}x{} pixels", test.width, test.height),
                fmt::format("{}x{}, the size of the reference", reference.width, reference.height));
  const double pixels = static_cast<double>(reference.rgb.size() / 3);
  const std::array<std::uint64_t, 3> sums = squared_differences(reference, test);
  PictureMetrics m;
  m.mse.r = static_cast<double>(sums[0]) / pixels;
  m.mse.g = static_cast<double>(sums[1]) / pixels;
  m.mse.b = static_cast<double>(sums[2]) / pixels;
  m.mse.mean = (m.mse.r + m.mse.g + m.mse.b) / 3.0;
  m.rmse = {std::sqrt(m.mse.r), std::sqrt(m.mse.g), std::sqrt(m.mse.b), std::sqrt(m.mse.mean)};
  m.psnr_db = psnr_db(m.mse.mean);
  m.ssim = ssim(reference, test);
  m.identical = sums[0] + sums[1] + sums[2] == 0;
  const YuvPsnr yuv = yuv_psnr(reference, test);
  m.psnr_y_db = yuv.y_db, m.psnr_yuv_db = yuv.yuv_db;
  if (wanted.ms_ssim) m.ms_ssim = ms_ssim(reference, test);
  if (wanted.flip) m.flip = flip(reference, test);
  return m;
}

}  // namespace lippmann

// Image metrics on 8-bit codes: mean squared error, PSNR, SSIM, MS-SSIM and FLIP.
//
// Definitions (also in docs/reference/metrics.md), for codes 0 ... 255 of reference a and test b:
//   MSE       per channel, the mean of (a - b)^2 over all pixels; mean MSE = (R + G + B) / 3
//   RMSE      square root of the MSE; mean RMSE = square root of the mean MSE
//   PSNR      10 log10(255^2 / mean MSE) dB; infinite for equal images
//   SSIM      Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to structural similarity",
//             IEEE Trans. Image Processing 13(4), 2004, eq. 13, with K1 = 0.01, K2 = 0.03, L = 255 and a normalised 11 x 11
//             Gaussian window of sigma 1.5. Computed for the luma Y = 0.299 R + 0.587 G + 0.114 B (BT.601, not rounded).
//             Averaged over all window positions inside the image. NaN if a side is below 11 pixels.
//   PSNR-Y    10 log10(255^2 / mean squared difference) dB of Y = 0.2126 R + 0.7152 G + 0.0722 B (BT.709, full range, not
//             rounded); infinite for equal luma
//   PSNR-YUV  (6 PSNR-Y + PSNR-U + PSNR-V) / 8 with U = (B - Y) / 1.8556, V = (R - Y) / 1.5748 at full resolution;
//             infinite if one of the three is infinite
//   MS-SSIM   Wang, Simoncelli, Bovik, "Multi-scale structural similarity for image quality assessment", 2003, eq. 7 with the
//             paper's five weights, for the same luma as SSIM. NaN if a side is below 161 pixels.
//   FLIP      LDR-FLIP, Andersson et al. 2020, at 67 pixels per degree: mean over the pixels, 0 ... 1
#pragma once

#include <optional>

#include "lippmann/image/image.hpp"

namespace lippmann {

struct ChannelErrors {
  double r = 0.0, g = 0.0, b = 0.0, mean = 0.0;
};

struct PictureMetrics {
  ChannelErrors mse{}, rmse{};  ///< mean of squared differences of codes, and its square root
  double psnr_db = 0.0;
  double ssim = 1.0;
  bool identical = true;
  double psnr_y_db = 0.0, psnr_yuv_db = 0.0;
  std::optional<double> ms_ssim = {}, flip = {};  ///< empty if not requested
};

/// Selects the slow metrics to compute.
struct SlowMetrics {
  bool ms_ssim = false, flip = false;
};

/// Throws Error if the sizes differ, if there are no pixels, or if samples are missing.
PictureMetrics measure_difference(const Image8& reference, const Image8& test, const SlowMetrics& wanted = {});

/// Returns infinity for an error of 0.
double psnr_db(double mean_mse);

}  // namespace lippmann

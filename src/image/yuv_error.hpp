// Computes PSNR-Y and PSNR-YUV, which image/metrics.hpp defines.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

struct YuvPsnr {
  double y_db = 0.0, yuv_db = 0.0;  ///< infinite for equal images
};

YuvPsnr yuv_psnr(const Image8& reference, const Image8& test);

}  // namespace lippmann

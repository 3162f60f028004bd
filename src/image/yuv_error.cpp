// Based on: Recommendation ITU-R BT.709-6, items 3.2 to 3.4 (luma and colour differences), in the full range 0 ... 255. The
// weights 6:1:1 of Y, U and V are from Ohm, Sullivan, Schwarz, Tan, Wiegand, "Comparison of the coding efficiency of video
// coding standards", IEEE Trans. Circuits and Systems for Video Technology 22(12), 2012, and JPEG Pleno's common test
// conditions.
//
// The conversion to YUV is linear, so it can be applied to differences of codes.
#include "image/yuv_error.hpp"

#include <cassert>
#include <cstddef>

#include "lippmann/image/metrics.hpp"

namespace lippmann {

YuvPsnr yuv_psnr(const Image8& reference, const Image8& test) {
  assert(reference.rgb.size() == test.rgb.size());
  double y2 = 0.0, u2 = 0.0, v2 = 0.0;
  for (std::size_t i = 0; i < reference.rgb.size(); i += 3) {
    const double r = reference.rgb[i] - test.rgb[i], g = reference.rgb[i + 1] - test.rgb[i + 1],
                 b = reference.rgb[i + 2] - test.rgb[i + 2];
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    // These forms of B - Y and R - Y are exactly 0 for grey.
    const double u = (0.2126 * (b - r) + 0.7152 * (b - g)) / 1.8556, v = (0.7152 * (r - g) + 0.0722 * (r - b)) / 1.5748;
    y2 += y * y, u2 += u * u, v2 += v * v;
  }
  const double pixels = static_cast<double>(reference.rgb.size() / 3);
  const double y_db = psnr_db(y2 / pixels);
  return {y_db, (6.0 * y_db + psnr_db(u2 / pixels) + psnr_db(v2 / pixels)) / 8.0};
}

}  // namespace lippmann

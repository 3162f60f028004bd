#include "view/disparity_codes.hpp"

#include <cmath>
#include <limits>

namespace lippmann {
namespace {

constexpr double kSteps = 65534.0;

}  // namespace

double disparity_mm(double z_mm, double vergence, double parallax) {
  // Computes w (see the header) times `parallax`, with V = 1 / vergence. At z = -infinity, w is -V. For points at or behind the
  // viewers (z >= V), returns infinity, which is encoded as no surface.
  const double before_viewer = 1.0 - z_mm * vergence;
  if (std::isinf(z_mm)) return vergence > 0.0 ? -parallax / vergence : -std::numeric_limits<double>::infinity();
  return before_viewer > 0.0 ? parallax * z_mm / before_viewer : std::numeric_limits<double>::infinity();
}

Image disparities_mm(const Image& depth, double vergence, double parallax) {
  Image disparities = depth;
  for (float& value : disparities.data) value = static_cast<float>(disparity_mm(value, vergence, parallax));
  return disparities;
}

Image8 disparity_codes(const Image& disparities, double scale_mm) {
  Image8 codes{disparities.width, disparities.height, std::vector<unsigned char>(disparities.data.size() * 3)};
  for (std::size_t i = 0; i < disparities.data.size(); ++i) {
    const double w = disparities.data[i];
    if (!std::isfinite(w)) continue;
    const double t = w / (std::abs(w) + scale_mm);
    const int code = 1 + static_cast<int>(std::lround(0.5 * kSteps * (t + 1.0)));
    codes.rgb[3 * i] = static_cast<unsigned char>(code >> 8), codes.rgb[3 * i + 1] = static_cast<unsigned char>(code & 255);
  }
  return codes;
}

}  // namespace lippmann

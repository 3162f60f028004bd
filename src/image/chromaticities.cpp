// Based on: SMPTE RP 177:1993, "Derivation of Basic Television Color Equations". The columns of the matrix from RGB to XYZ are
// the XYZ colours of the primaries, scaled so that they sum to white. Other white points are adapted with K. M. Lam's Bradford
// matrix, as in ICC.1:2010, annex E.
#include "image/chromaticities.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

namespace lippmann {
namespace {

using glm::dmat3;
using glm::dvec3;

dvec3 with_z(double x, double y) { return {x, y, 1.0 - x - y}; }

dvec3 white_xyz(const Chromaticities& c) { return with_z(c.xy[6], c.xy[7]) / c.xy[7]; }

dmat3 xyz_from_rgb(const Chromaticities& c) {
  const dmat3 primaries(with_z(c.xy[0], c.xy[1]), with_z(c.xy[2], c.xy[3]), with_z(c.xy[4], c.xy[5]));
  const dvec3 scale = glm::inverse(primaries) * white_xyz(c);
  return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

dmat3 adaptation(const dvec3& from_white, const dvec3& to_white) {
  const dmat3 cones = glm::transpose(dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const dvec3 ratio = (cones * to_white) / (cones * from_white);
  return glm::inverse(cones) * dmat3(ratio.x, 0.0, 0.0, 0.0, ratio.y, 0.0, 0.0, 0.0, ratio.z) * cones;
}

bool is_finite(const dmat3& matrix) {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!std::isfinite(matrix[column][row]) || std::abs(matrix[column][row]) > 1e3) return false;
  return true;
}

}  // namespace

bool are_rec709(const Chromaticities& chromaticities) {
  constexpr double kRounded = 1e-3;
  const Chromaticities rec709;
  return std::equal(chromaticities.xy.begin(), chromaticities.xy.end(), rec709.xy.begin(),
                    [](double a, double b) { return std::abs(a - b) <= kRounded; });
}

std::optional<dmat3> rec709_from(const Chromaticities& chromaticities) {
  const Chromaticities rec709;
  const dmat3 matrix = glm::inverse(xyz_from_rgb(rec709)) * adaptation(white_xyz(chromaticities), white_xyz(rec709)) *
                       xyz_from_rgb(chromaticities);
  return is_finite(matrix) ? std::optional(matrix) : std::nullopt;
}

void convert_colors(const dmat3& matrix, std::span<float> samples, std::size_t channels) {
  for (std::size_t i = 0; i + 2 < samples.size(); i += channels) {
    const dvec3 color = matrix * dvec3(samples[i], samples[i + 1], samples[i + 2]);
    if (!std::isfinite(color.x + color.y + color.z)) continue;
    for (int c = 0; c < 3; ++c) samples[i + static_cast<std::size_t>(c)] = static_cast<float>(color[c]);
  }
}

}  // namespace lippmann

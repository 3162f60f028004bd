// Converts linear colours with the primaries and white point of a file to linear Rec. 709 (sRGB). Private to src/image.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>

namespace lippmann {

/// CIE x and y of red, green, blue and white.
struct Chromaticities {
  std::array<double, 8> xy{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
};

/// For CIE XYZ data: the primaries are X, Y and Z, and white is X = Y = Z.
inline constexpr Chromaticities kXyz{{1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0}};

bool are_rec709(const Chromaticities& chromaticities);

/// Returns the matrix from linear colours to linear Rec. 709, with Bradford adaptation of the white point. Colours outside Rec.
/// 709 get negative components. Returns nothing if the chromaticities are degenerate.
std::optional<glm::dmat3> rec709_from(const Chromaticities& chromaticities);

/// `channels` is the number of samples per pixel; the first three are the colour. Colours that are not finite do not change.
void convert_colors(const glm::dmat3& matrix, std::span<float> samples, std::size_t channels);

}  // namespace lippmann

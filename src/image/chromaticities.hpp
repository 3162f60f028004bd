// The colours that a file's red, green and blue stand for, and the matrix to those of this project: linear light with the
// primaries and the white of Rec. 709 (sRGB). Private to src/image.
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

/// X, Y and Z themselves as the three primaries; white is (1, 1, 1).
inline constexpr Chromaticities kXyz{{1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0}};

/// Within what files round to.
bool are_rec709(const Chromaticities& chromaticities);

/// Takes linear colours to linear Rec. 709. White stays white: where the whites differ, by Bradford's adaptation. Colours that
/// Rec. 709 cannot show get negative components. None if the chromaticities span no colours.
std::optional<glm::dmat3> rec709_from(const Chromaticities& chromaticities);

/// Multiplies the first three of every `channels` samples. Colours that are not finite stay.
void convert_colors(const glm::dmat3& matrix, std::span<float> samples, std::size_t channels);

}  // namespace lippmann

// Models crosstalk: through a lens, an eye sees light of one pixel and some light of the neighbouring pixels. For quilts, the
// eye sees light of one view and some light of the neighbouring views.
//
// The blur of a lens is a Gaussian on the panel, whose sigma is given in pixels. The weight of a pixel is the integral of the
// Gaussian over the pixel.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

inline constexpr double kMaxBlurPx = 8.0;

struct Tap {
  int index;
  double weight;
};

/// The weights of a filter along one axis. Elements from `count` on are uninitialised.
struct Taps {
  std::array<Tap, 84> tap;
  int count = 0;

  void add(int index, double weight) { tap[static_cast<std::size_t>(count++)] = {index, weight}; }
  const Tap* begin() const { return tap.data(); }
  const Tap* end() const { return tap.data() + count; }
};

/// Returns the weights of the pixels seen at a position in continuous pixel coordinates, where pixel i covers [i, i + 1). A
/// weight is the integral of a Gaussian of `sigma_px`, cut off at 4 sigma. `sigma_px` is above 0 and at most kMaxBlurPx.
/// Callers skip indices outside the image and renormalise the remaining weights.
Taps gaussian_taps(double position_px, double sigma_px);

/// Returns the sigma of the blur along x and y, in pixels of the panel; 0 if the lenses have no power along the axis. For
/// quilts, the unit is one view instead of one pixel. For slanted panels, each colour is blurred separately. `sigma_px` is
/// measured perpendicular to the lenses.
Vec2d crosstalk_sigmas(const Optics& optics, double sigma_px);

/// Returns the weight of each of the two neighbouring pixels, for an eye that sees the middle of a pixel.
double neighbour_share(double sigma_px);

/// Parses crosstalk and returns its sigma. "0.4" is a sigma in pixels, 0 ... kMaxBlurPx. "10%" is the weight of each
/// neighbouring pixel, 0 ... 23 %. Throws a usage Error naming `where`.
double read_crosstalk(std::string_view text, const std::string& where);

}  // namespace lippmann

// Crosstalk: how much light of the neighbouring pixels (for quilts: views) an eye sees in addition to the pixel that it should
// see through a lens.
//
// A lens images each point of the panel as a Gaussian with a sigma given in panel pixels (for quilts: in views), integrated
// over the area of each pixel. Both replay, which simulates crosstalk, and precompensation (layout/precompensate.hpp), which
// counteracts it, use this definition.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

inline constexpr double kMaxBlurPx = 8.0;

/// The weight of one pixel along one axis of a filter.
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

/// Returns the weights of the pixels seen at a position in continuous pixel coordinates (pixel i covers i ... i + 1): a
/// Gaussian of `sigma_px`, 0 < sigma <= kMaxBlurPx, cut off at 4 sigma and integrated over each pixel. As sigma approaches 0 it
/// becomes the nearest pixel. Indices may lie outside the image; callers skip those and renormalise the other weights.
Taps gaussian_taps(double position_px, double sigma_px);

/// Returns the standard deviation of the blur along x and y, in pixels of a panel picture (quilts: in columns and rows of
/// views; slanted panels: in whole pixels, for each colour). It is 0 along axes without lens power. For a slanted sheet,
/// sigma_px is measured perpendicular to its lenses.
Vec2d crosstalk_sigmas(const Optics& optics, double sigma_px);

/// Returns the weight of each of the two direct neighbours, for an eye that sees the middle of a pixel.
double neighbour_share(double sigma_px);

/// Parses crosstalk: "0.4" is a sigma in pixels, 0 ... kMaxBlurPx; "10%" is the weight of each direct neighbour, 0 ... 23 %.
/// Returns the sigma. Throws a usage Error naming `where`.
double read_crosstalk(std::string_view text, const std::string& where);

}  // namespace lippmann

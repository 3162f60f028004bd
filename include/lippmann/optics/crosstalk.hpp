// Crosstalk: how much of its neighbours an eye sees where one pixel below a lens, or one view of a quilt, is meant.
//
// A lens images the panel not as points but as a Gaussian of a sigma in panel pixels (of a quilt: views), which each pixel
// integrates over its area. The one definition for replay, which shows it, and for pictures made to undo it
// (layout/precompensate.hpp).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

inline constexpr double kMaxBlurPx = 8.0;

/// Which pixel of one axis counts how much.
struct Tap {
  int index;
  double weight;
};

/// Uninitialised beyond `count`.
struct Taps {
  std::array<Tap, 84> tap;
  int count = 0;

  void add(int index, double weight) { tap[static_cast<std::size_t>(count++)] = {index, weight}; }
  const Tap* begin() const { return tap.data(); }
  const Tap* end() const { return tap.data() + count; }
};

/// What is seen at a place in continuous pixel coordinates (pixel i covers i ... i + 1): a Gaussian of `sigma_px`, 0 < sigma <=
/// kMaxBlurPx, cut off at 4 sigma and integrated over each pixel; for sigma -> 0 it is the nearest pixel. Indices may lie
/// outside any picture: what lies beyond is left out, and the rest of the weights counts for all.
Taps gaussian_taps(double position_px, double sigma_px);

/// Sigma along x and along y in pixels of a panel picture (of quilts: columns and rows of views; of slanted panels: whole
/// pixels, each colour for itself); 0 where lenses have no power. A slanted sheet's is measured across its lenses.
Vec2d crosstalk_sigmas(const Optics& optics, double sigma_px);

/// The share of what is seen at the middle of a pixel that is each neighbour's.
double neighbour_share(double sigma_px);

/// "0.4": a sigma in pixels, 0 ... kMaxBlurPx; "10%": the one of which each neighbour has that share, 0 ... 23 %. Throws a
/// usage Error naming `where`.
double read_crosstalk(std::string_view text, const std::string& where);

}  // namespace lippmann

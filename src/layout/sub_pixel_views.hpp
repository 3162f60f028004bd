#pragma once

#include <array>
#include <cmath>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// One row of a slanted panel. view(i, color) returns the view coordinate v of a sub-pixel of pixel i.
struct SubPixelRow {
  /// phase[i & 1][color]: phase that pixel 0 would have if its sub-pixels were arranged as in pixel i.
  std::array<std::array<double, 3>, 2> phase;
  double phase_per_pixel;
  bool inverted;

  double view(int i, int color) const {
    const double z = phase[static_cast<std::size_t>(i & 1)][static_cast<std::size_t>(color)] + i * phase_per_pixel;
    const double in_lens = z - std::floor(z);
    return inverted ? 1.0 - in_lens : in_lens;
  }
};

/// Row j of the panel, counted from the top.
inline SubPixelRow sub_pixel_row(const SlantedPanel& panel, Vec2i pixels, int j) {
  SubPixelRow row{{}, panel.periods / pixels.x, panel.inverted};
  const int up = pixels.y - 1 - j;
  for (std::size_t parity = 0; parity < 2; ++parity)
    for (std::size_t color = 0; color < 3; ++color) {
      const Vec2f offset = panel.sub_pixels[static_cast<std::size_t>(up & 3)][parity][color];
      const double x = (0.5 + static_cast<double>(offset.x)) / pixels.x;
      const double y = (up + 0.5 + static_cast<double>(offset.y)) / pixels.y;
      row.phase[parity][color] = (x + y * panel.tilt) * panel.periods - panel.center;
    }
  return row;
}

/// The view, of `count` views, that is nearest to the view coordinate v.
inline int nearest_view(double v, int count) {
  const int view = static_cast<int>(v * count);
  return view < count ? view : count - 1;
}

/// The sample that contains the centre of pixel i, if `pixels` pixels are divided into `size` samples.
inline int sample_at(int i, int pixels, int size) {
  return static_cast<int>((2 * static_cast<std::int64_t>(i) + 1) * size / (2 * static_cast<std::int64_t>(pixels)));
}

}  // namespace lippmann

// Finds the sub-pixel of a slanted panel on which a moved point lands. No two rows of a slanted panel share their ray
// directions.
//
// The original sub-pixel saw a point that has moved to (X, Y, Z). The original ray comes from the eye at (e, h, D). The phase
// of a sub-pixel is its position below its lens, as a fraction of the lens pitch.
// 1. Seen from the eye, the point appears in the plane z = 0 at
//      s = (X - e Z / D) / (1 - Z / D),   y = (Y - h Z / D) / (1 - Z / D).
// 2. The row of the result is the row that contains y.
// 3. In that row, the phase of the original sub-pixel recurs once per lens. The result is the recurrence nearest to s, which is
//    at most half a lens away. If the phase at s exceeds the original phase by d, the result is d - round(d) lenses left of s.
// Rounding to whole sub-pixels changes the phase by at most half a sub-pixel.
//
// Only striped sub-pixels are supported, because for other layouts the position of a sub-pixel does not follow from its number.
//
// The other symbols are those of optics/slanted_panel.hpp. The functions are inlined into loops, so that the compiler can
// vectorise the loops.
#pragma once

#include "optics/slanted_panel.hpp"
#include "reuse/landing.hpp"

namespace lippmann {

struct SlantedLanding {
  struct Row {
    SlantedPanelRays c;  ///< positions at z = 0 and slopes of the rays
    float lenses_per_sub_pixel, sub_pixels_per_lens;
    float lenses_per_row;  ///< change of the phase from a row to the row below
    float sub_pixels_per_mm, width, height, middle_x, middle_y;
    /// -1 if blue is the first sub-pixel of a pixel, otherwise 1
    float turned;
    float px, py;  ///< panel coordinates of the centre of pixel 0, in pixels
  };

  Row constants;

  Row row(int j, int i) const {
    Row r = constants;
    r.px = static_cast<float>(i) + 0.5f, r.py = static_cast<float>(j) + 0.5f;
    return r;
  }
};

/// Converts a film column to a position along the row, in sub-pixels, or back. Sub-pixel k is centred at k + 0.5.
LIPPMANN_INLINE float along_row(const SlantedLanding::Row& r, float column) {
  const float pixel = std::floor(column * (1.0f / 3.0f)), middle = 3.0f * pixel + 1.5f;
  return middle + r.turned * (column - middle);
}

LIPPMANN_INLINE Vec3f point_by(const SlantedLanding&, const SlantedLanding::Row& row, int i, float z) {
  return point_on(crossing(row.c, row.px + static_cast<float>(i), row.py), z);
}

LIPPMANN_INLINE PointLanding land_by(const SlantedLanding&, const SlantedLanding::Row& r, int i, float x, float y, float z) {
  const Crossing from = crossing(r.c, r.px + static_cast<float>(i), r.py);
  const float eye = from.x + r.c.distance_mm * from.slope_x, depth = z * r.c.inverse_distance;
  const float from_eye = 1.0f - depth, q = 1.0f / from_eye;
  const float s = r.middle_x + (x - eye * depth) * q * r.sub_pixels_per_mm;
  const float down = r.middle_y - (y - r.c.eye_y_mm * depth) * q * r.sub_pixels_per_mm * (1.0f / 3.0f);
  const float row = std::floor(down);
  const float here = along_row(r, r.px + static_cast<float>(i));
  const float difference = (s - here) * r.lenses_per_sub_pixel + (row + 0.5f - r.py) * r.lenses_per_row;
  const float off = difference - std::floor(difference + 0.5f);
  const float place = std::floor(s - off * r.sub_pixels_per_lens) + 0.5f;
  const float column = std::floor(along_row(r, place));
  const bool seen = (from_eye > 0.0f) & (column >= 0.0f) & (column < r.width);
  return {pixel_if(seen, column), pixel_if((row >= 0.0f) & (row < r.height), row), off, down - row - 0.5f};
}

}  // namespace lippmann

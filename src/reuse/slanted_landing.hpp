// Projects a moved point to a slanted panel, where no two rows share their directions.
//
// The sub-pixel's ray comes from the eye at (e, h, D). From there, the point (X, Y, Z) appears in the plane z = 0 at
//   s = (X - e Z / D) / (1 - Z / D),   y = (Y - h Z / D) / (1 - Z / D),
// in the row that contains y. That row has one sub-pixel below each lens with the phase of the original sub-pixel; the one
// nearest to s is used. If d is the difference between the phase at s and that phase, it lies at s - (d - round(d)) lenses. Its
// ray has the same direction to within half the distance between two sub-pixels, and it is at most half a lens from s. Static
// points stay in place. Only striped sub-pixels are supported, because otherwise a sub-pixel's place does not follow from its
// number.
//
// Symbols as in optics/slanted_panel.hpp. As in landing.hpp, the functions are inlined into loops so that these vectorise.
#pragma once

#include "optics/slanted_panel.hpp"
#include "reuse/landing.hpp"

namespace lippmann {

struct SlantedLanding {
  struct Row {
    SlantedPanelRays c;  ///< at z = 0
    float lenses_per_sub_pixel, sub_pixels_per_lens;
    float lenses_per_row;  ///< change of the phase per row down
    float sub_pixels_per_mm, width, height, middle_x, middle_y;
    float turned;  ///< -1: blue comes first, so positions within a pixel count from the right; otherwise 1
    float px, py;  ///< centre of entry 0
  };

  Row constants;

  Row row(int j, int i) const {
    Row r = constants;
    r.px = static_cast<float>(i) + 0.5f, r.py = static_cast<float>(j) + 0.5f;
    return r;
  }
};

/// Converts a film column (centre at + 0.5) to its position along the row, in sub-pixels. The function is its own inverse.
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

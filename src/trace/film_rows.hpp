// The rows of a film to render: all rows, or a range that begins and ends at strip boundaries (strip_order.hpp).
//
// A render of a range uses the same rays, samples and random numbers as a render of the whole film. Its images hold only the
// range, and pixel indices count from the first pixel of the range.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct FilmRows {
  int first = 0;
  int end = std::numeric_limits<int>::max();  ///< one past the last row; values above the film's height mean the last row
  bool operator==(const FilmRows&) const = default;
};

/// Returns the size of an image that holds only these rows.
inline Vec2i film_size(const Optics& optics, FilmRows rows) {
  const Vec2i film = film_size(optics);
  return {film.x, std::min(rows.end, film.y) - rows.first};
}

/// Returns the index in the whole film of the first pixel of these rows.
inline std::uint32_t first_pixel(const Optics& optics, FilmRows rows) {
  return static_cast<std::uint32_t>(rows.first) * static_cast<std::uint32_t>(film_size(optics).x);
}

}  // namespace lippmann

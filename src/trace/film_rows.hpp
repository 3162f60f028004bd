// The rows of a film to render. The range begins and ends at strip boundaries (strip_order.hpp).
//
// Rays, samples and random numbers do not depend on the range. Images hold only these rows, and pixel indices count from the
// first of these rows.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct FilmRows {
  int first = 0;
  int end = std::numeric_limits<int>::max();  ///< one past the last row; a value above the film's height means all rows
  bool operator==(const FilmRows&) const = default;
};

inline Vec2i film_size(const Optics& optics, FilmRows rows) {
  const Vec2i film = film_size(optics);
  return {film.x, std::min(rows.end, film.y) - rows.first};
}

inline std::uint32_t first_pixel(const Optics& optics, FilmRows rows) {
  return static_cast<std::uint32_t>(rows.first) * static_cast<std::uint32_t>(film_size(optics).x);
}

}  // namespace lippmann

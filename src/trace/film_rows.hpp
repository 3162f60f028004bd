// The rows of a film that are rendered: all of it, or a part that begins and ends where strips do (strip_order.hpp).
//
// Rays, samples and random numbers are those that the rows' pixels have in the whole film. Images of a part hold its rows
// alone: pixels are counted from the first of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct FilmRows {
  int first = 0;
  int end = std::numeric_limits<int>::max();  ///< one beyond the last; beyond the film: all that there are
  bool operator==(const FilmRows&) const = default;
};

/// The size of an image of these rows.
inline Vec2i film_size(const Optics& optics, FilmRows rows) {
  const Vec2i film = film_size(optics);
  return {film.x, std::min(rows.end, film.y) - rows.first};
}

/// The number that the first pixel of an image of these rows has in the whole film.
inline std::uint32_t first_pixel(const Optics& optics, FilmRows rows) {
  return static_cast<std::uint32_t>(rows.first) * static_cast<std::uint32_t>(film_size(optics).x);
}

}  // namespace lippmann

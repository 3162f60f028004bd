// Where a number lies in a table of evenly spaced values over [0, 1].
#pragma once

#include <algorithm>

#include "core/multiversion.hpp"

namespace lippmann {

/// Entry `index`, and how far on the way to the next. Numbers beyond the ends lie at them. size >= 2. |x| size within int's
/// range.
struct TablePlace {
  LIPPMANN_INLINE TablePlace(float x, int size) {
    const float at = x * static_cast<float>(size - 1);
    // Held within bounds as a whole number: of bounds on x the compiler makes branches.
    index = std::min(std::max(static_cast<int>(at), 0), size - 2);
    const float beyond = at - static_cast<float>(index), above = beyond > 0.0f ? beyond : 0.0f;
    share = above < 1.0f ? above : 1.0f;
  }
  int index;  ///< not std::size_t, which the compiler does not gather by
  float share;
};

}  // namespace lippmann

// Where a number lies in a table of evenly spaced values over [0, 1].
#pragma once

#include <algorithm>
#include <cstddef>

namespace lippmann {

/// Entry `index`, and how far on the way to the next. Numbers beyond the ends lie at them. size >= 2.
struct TablePlace {
  TablePlace(float x, int size) {
    const float at = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(size - 1);
    index = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(size - 2));
    share = at - static_cast<float>(index);
  }
  std::size_t index;
  float share;
};

}  // namespace lippmann

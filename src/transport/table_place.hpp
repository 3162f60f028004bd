#pragma once

#include <algorithm>

#include "core/multiversion.hpp"

namespace lippmann {

/// Computes the index of a table's entry for x, and the interpolation weight of the next entry. x is clamped to [0, 1]. `size`
/// must be >= 2, and |x| * size must fit into an int.
struct TablePlace {
  LIPPMANN_INLINE TablePlace(float x, int size) {
    const float at = x * static_cast<float>(size - 1);
    // Clamp the integer, because compilers turn a clamp of x into branches.
    index = std::min(std::max(static_cast<int>(at), 0), size - 2);
    const float beyond = at - static_cast<float>(index), above = beyond > 0.0f ? beyond : 0.0f;
    share = above < 1.0f ? above : 1.0f;
  }
  int index;  ///< of type int, because compilers do not vectorise lookups by std::size_t
  float share;
};

}  // namespace lippmann

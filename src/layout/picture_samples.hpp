// The samples of pictures of any depth, for code that is the same for all.
#pragma once

#include <cmath>
#include <type_traits>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Row by row, channels side by side; of Image, Image8 or Image16.
template <class T>
auto& samples_of(T& image) {
  if constexpr (std::is_same_v<std::remove_const_t<T>, Image>)
    return image.data;
  else
    return image.rgb;
}

/// What a sample becomes that was mixed of others: of codes the nearest one.
template <class Sample>
Sample nearest_sample(double value) {
  return static_cast<Sample>(std::is_floating_point_v<Sample> ? value : std::floor(value + 0.5));
}

}  // namespace lippmann

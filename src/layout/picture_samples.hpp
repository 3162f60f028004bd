#pragma once

#include <cmath>
#include <type_traits>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Samples of Image, Image8 or Image16: row by row, with interleaved channels.
template <class T>
auto& samples_of(T& image) {
  if constexpr (std::is_same_v<std::remove_const_t<T>, Image>)
    return image.data;
  else
    return image.rgb;
}

/// Converts an interpolated value to a sample. Rounds the value if samples are integers.
template <class Sample>
Sample nearest_sample(double value) {
  return static_cast<Sample>(std::is_floating_point_v<Sample> ? value : std::floor(value + 0.5));
}

}  // namespace lippmann

// What is measured of pictures: sRGB's codes of chosen pixels, and means with what they are uncertain by.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/image/encode.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// sRGB's code from 0 to 1.
inline float code_of(float linear) { return static_cast<float>(srgb_from_linear(std::clamp(linear, 0.0f, 1.0f))); }

/// Light as far as it is shown.
inline float shown_light(float linear) { return std::clamp(linear, 0.0f, 1.0f); }

/// By how much codes of light change with it (the slope of sRGB's curve).
inline double slope_of_code(double linear) {
  return linear <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(std::min(linear, 1.0), 1.0 / 2.4 - 1.0);
}

/// Linear, three channels a pixel.
inline std::vector<float> light_at(const Image& film, std::span<const std::uint32_t> pixels) {
  std::vector<float> light;
  light.reserve(3 * pixels.size());
  for (const std::uint32_t pixel : pixels) {
    const auto first = film.data.begin() + static_cast<std::ptrdiff_t>(3 * static_cast<std::size_t>(pixel));
    light.insert(light.end(), first, first + 3);
  }
  return light;
}

inline std::vector<float> codes_at(const Image& film, std::span<const std::uint32_t> pixels) {
  std::vector<float> codes = light_at(film, pixels);
  for (float& c : codes) c = code_of(c);
  return codes;
}

/// The mean of some values, and its standard deviation.
class MeanOf {
 public:
  void add(double v) { sum_ += v, squares_ += v * v, count_ += 1.0; }
  float mean() const { return static_cast<float>(sum_ / std::max(count_, 1.0)); }
  float uncertainty() const {
    const double m = sum_ / std::max(count_, 1.0);
    const double variance = std::max(0.0, squares_ / std::max(count_, 1.0) - m * m);
    return static_cast<float>(std::sqrt(variance / std::max(count_ - 1.0, 1.0)));
  }

 private:
  double sum_ = 0.0, squares_ = 0.0, count_ = 0.0;
};

}  // namespace lippmann

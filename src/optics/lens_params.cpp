#include "optics/lens_params.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lippmann/core/error.hpp"

namespace lippmann {

int covered_pixels(int lenses, float pixels) {
  const double product = static_cast<double>(lenses) * static_cast<double>(pixels);
  return static_cast<int>(std::clamp(std::round(product), 1.0, 2147483647.0));
}

void require_agreement(int size, int lenses, float pixels, const char* direction) {
  if (std::abs(static_cast<float>(lenses) * pixels - static_cast<float>(size)) < 1.0f) return;
  throw usage_error("size",
                    fmt::format("{} pixels {}, but {} lenses of {} pixels make {}", size, direction, lenses, pixels,
                                covered_pixels(lenses, pixels)),
                    "two of `size`, `lenses` and `lens-pixels`, or three consistent values");
}

float lens_pixels_across(const OpticsParams& params) {
  constexpr float kDefaultLensPixels = 8.0f;
  const int size = params.size.x, lenses = params.lenses.x;
  const float pixels = params.lens_pixels.x;
  if (pixels > 0.0f && size > 0 && lenses > 0) require_agreement(size, lenses, pixels, "across");
  if (pixels > 0.0f) return pixels;
  if (size == 0 || lenses == 0) return kDefaultLensPixels;
  if (size < lenses)
    throw usage_error("lenses", fmt::format("{} lenses do not fit on {} pixels", lenses, size),
                      fmt::format("1 to {}, at most one lens per pixel", size));
  return static_cast<float>(size) / static_cast<float>(lenses);
}

float cell_center_nearest_middle(float extent, float cell) {
  const float middle = 0.5f * extent;
  return (std::floor(middle / cell) + 0.5f) * cell - middle;
}

LensGeometry lens_geometry(float cell_mm, const OpticsParams& params, float viewing_distance_mm) {
  const float gap = cell_mm / (2.0f * std::tan(0.5f * view_angle(params)));
  const float pitch_per_cell = 1.0f / (1.0f + gap / viewing_distance_mm);
  return {cell_mm * pitch_per_cell, gap, pitch_per_cell};
}

}  // namespace lippmann

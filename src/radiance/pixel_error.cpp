#include "radiance/pixel_error.hpp"

#include <utility>

#include "core/random.hpp"
#include "radiance/measured_codes.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {

PixelMeasure::PixelMeasure(const Shot& shot, const TraceParams& trace, MeasuredPixels where, int sets, const Workers& workers)
    : where_(std::move(where)) {
  Image film(film_size(shot).x, film_size(shot).y, 3);
  TraceParams params = trace;
  for (int set = 0; set < sets; ++set) {
    params.seed = hash(trace.seed, trace.frame, 0x70697865u + static_cast<std::uint32_t>(set));
    add(trace_pixels(shot, params, where_.pixels, workers, film), counts_);
    light_.push_back(light_at(film, where_.pixels));
    sets_.push_back(codes_at(film, where_.pixels));
  }
}

/// squared(i), of a channel of a pixel.
template <class Squared>
PixelError PixelMeasure::mean_of(const Squared& squared) const {
  MeanOf pixels;
  for (std::size_t p = 0; p < where_.weights.size(); ++p)
    pixels.add(where_.weights[p] * (squared(3 * p) + squared(3 * p + 1) + squared(3 * p + 2)) / 3.0);
  return {pixels.mean(), pixels.uncertainty()};
}

PixelError PixelMeasure::of_paths() const {
  return mean_of([&](std::size_t i) {
    const auto d = static_cast<double>(sets_[0][i] - sets_[1][i]);
    return 0.5 * d * d;
  });
}

PixelError PixelMeasure::of_paths(const Image& film) const {
  const std::vector<float> codes = codes_at(film, where_.pixels);
  return mean_of([&](std::size_t i) {
    const auto d = static_cast<double>(codes[i] - sets_[0][i]);
    return 0.5 * d * d;
  });
}

PixelError PixelMeasure::error_of(const Image& film) const {
  const std::vector<float> codes = codes_at(film, where_.pixels);
  return mean_of(
      [&](std::size_t i) { return static_cast<double>(codes[i] - sets_[0][i]) * static_cast<double>(codes[i] - sets_[1][i]); });
}

}  // namespace lippmann

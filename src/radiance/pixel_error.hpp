// How much the pixels of a frame err, measured on some of them against paths.
#pragma once

#include "radiance/measured_places.hpp"

namespace lippmann {

/// Mean squared error of sRGB's codes (0 ... 1), and the standard deviation of this measurement.
struct PixelError {
  float squared = 0.0f, uncertainty = 0.0f;
};

/// Some pixels of a frame, traced again by as many paths as a whole frame has, once or twice, with random numbers of their own.
/// Fewer paths for more pixels would tell less, as sRGB's curve makes noise darker.
class PixelMeasure {
 public:
  PixelMeasure(const Shot& shot, const TraceParams& trace, MeasuredPixels where, int sets, const Workers& workers);

  /// The error of paths with trace.spp samples: half the squared difference of both sets.
  PixelError of_paths() const;
  /// Likewise, of those that made this picture, and one set.
  PixelError of_paths(const Image& film) const;

  /// The error of a picture made by any means: what it differs by from one set, times what it differs by from the other, is its
  /// squared error on average, as what both sets err by has nothing to do with each other.
  PixelError error_of(const Image& film) const;

  const MeasuredPixels& where() const { return where_; }
  /// Linear, three channels a pixel.
  const std::vector<float>& light(int set) const { return light_[static_cast<std::size_t>(set)]; }

  /// All rays that were traced.
  const RayCounts& counts() const { return counts_; }

 private:
  template <class Squared>
  PixelError mean_of(const Squared& squared) const;

  MeasuredPixels where_;
  std::vector<std::vector<float>> light_;  ///< by set
  std::vector<std::vector<float>> sets_;   ///< its codes, three channels a pixel
  RayCounts counts_;
};

}  // namespace lippmann

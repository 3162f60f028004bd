// Removes the noise of path tracing from a frame of a light field. Noise-free features (albedo, normal and depth) guide the
// filter.
//
//   1. Light is divided by the albedo, so that the filter does not blur textures.
//   2. Each pixel is averaged with pixels of neighbouring views that show the same point, found by its depth.
//   3. Each pixel is averaged with its neighbours in the same view, in passes with steps of 1, 2 and 4 pixels.
// A neighbour's weight decreases with the difference between the two surfaces, and with the difference in light as far as it
// exceeds the noise. The variance of a pixel is estimated from the two halves of its samples.
//
// Based on: H. Dammertz et al., "Edge-avoiding a-trous wavelet transform for fast global illumination filtering", HPG 2010
// (steps that double); C. Schied et al., "Spatiotemporal variance-guided filtering", HPG 2017 (division by albedo, weights that
// depend on a filtered variance); F. Rousselle et al., "Adaptive rendering with non-local means filtering", SIGGRAPH Asia 2012
// (variance from two half buffers, distances minus their expected noise). We deviate: the filter averages over neighbouring
// views instead of earlier frames, and between views it compares means over neighbours instead of single pixels.
#pragma once

#include <limits>
#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct DenoiserInput {
  Image &film, &noise, &seen, &albedo, &normal, &z, &met;
  /// Rotates directions from the world to the display frame. The scale of the matrix does not matter.
  Mat3f display_from_world{1.0f};
};

class Denoiser {
 public:
  explicit Denoiser(const Optics& optics, int first_row = 0, int end_row = std::numeric_limits<int>::max());
  ~Denoiser();

  /// Returns the denoised film. The result does not depend on the number of threads or on the processor.
  Image denoise(const DenoiserInput& frame, const ThreadPool& pool) const;

  static int rows_around(const Optics& optics);

  /// Working memory of denoise() in bytes per pixel, in addition to the frame. Measured: 36 bytes for quilts, 40 for hexagonal
  /// lenses.
  static constexpr double kWorkBytesPerPixel = 40.0;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

// Removes the noise of path tracing from a frame of a light field. Noise-free features (albedo, normal and depth) guide the
// filter.
//
//   1. Light is divided by the albedo, so that the filter does not blur textures.
//   2. Each pixel is averaged with pixels of neighbouring views that show the same point. The pixel's depth gives the positions
//      of these pixels.
//   3. Each pixel is averaged with its neighbours in the same view, in passes with steps of 1, 2 and 4 pixels.
// A neighbour's weight decreases with the difference between the two surfaces. It also decreases with the difference in light,
// as far as this difference exceeds the noise. The variance of a pixel is estimated from the two halves of its samples.
//
// The inner loops of all steps run over one row of a view and use one array per component, so that the compiler can vectorise
// them (core/multiversion.hpp).
//
// Based on: H. Dammertz et al., "Edge-avoiding a-trous wavelet transform for fast global illumination filtering", HPG 2010
// (steps that double); C. Schied et al., "Spatiotemporal variance-guided filtering", HPG 2017 (division by albedo, weights that
// depend on a filtered variance); F. Rousselle et al., "Adaptive rendering with non-local means filtering", SIGGRAPH Asia 2012
// (variance from two half buffers, distances minus their expected noise).
// We deviate in two points. The filter averages over neighbouring views instead of earlier frames, so that each frame is
// denoised on its own. Between views, it compares means over neighbours on the same surface instead of single pixels.
#pragma once

#include <limits>
#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// The images of a NoisyFrame (trace/noisy_frame.hpp), all of the same size. denoise() overwrites them.
struct DenoiserInput {
  Image &film, &noise, &seen, &albedo, &normal, &z, &met;
  /// Rotates directions from the world to the display frame. The scale of the matrix does not matter.
  Mat3f display_from_world{1.0f};
};

class Denoiser {
 public:
  /// Frames hold the rows first_row to end_row - 1 of the film. end_row is limited to the film's height.
  explicit Denoiser(const Optics& optics, int first_row = 0, int end_row = std::numeric_limits<int>::max());
  ~Denoiser();

  /// Returns the denoised film. The result does not depend on the number of threads or on the processor.
  Image denoise(const DenoiserInput& frame, const ThreadPool& pool) const;

  /// Returns how many film rows above and below a row affect its result. To get the same result as in the whole film, a frame
  /// must hold this many rows above and below, or all rows up to the film's edge. For quilts with several rows of tiles, the
  /// number is the film's height.
  static int rows_around(const Optics& optics);

  /// Working memory of denoise() in bytes per pixel, in addition to the frame. It holds two estimates of light and the film
  /// pixel of each view pixel. Measured: 36 bytes for quilts, 40 for hexagonal lenses.
  static constexpr double kWorkBytesPerPixel = 40.0;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

// Removes the noise of path tracing from a frame of a light field. Noise-free features (albedo, normal and depth) guide the
// filter.
//
// Light is divided by the albedo, so that textures are not blurred. Each pixel is averaged with pixels that show the same point
// in neighbouring views; its depth gives their positions. It is then averaged with its neighbours in the same view, in passes
// with steps of 1, 2 and 4 pixels. A neighbour's weight decreases with the difference between the two surfaces, and with the
// difference in light that exceeds the noise. The variance of a pixel is estimated from the two halves of its samples.
//
// The inner loops of all passes run over one row of a view, with one array per component, and the compiler vectorises them
// (core/multiversion.hpp).
//
// Based on: H. Dammertz et al., "Edge-avoiding a-trous wavelet transform for fast global illumination filtering", HPG 2010
// (steps that double); C. Schied et al., "Spatiotemporal variance-guided filtering", HPG 2017 (division by albedo, weights that
// depend on a variance, which is filtered too); F. Rousselle et al., "Adaptive rendering with non-local means filtering",
// SIGGRAPH Asia 2012 (variance from two half buffers, distances minus their expected noise).
// This implementation deviates in two points: (1) it averages over neighbouring views instead of earlier frames, so each frame
// is denoised on its own; (2) between views, it compares means over neighbours on the same surface instead of single pixels.
#pragma once

#include <limits>
#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// The images of a NoisyFrame (trace/noisy_frame.hpp), all of the same size. Denoising overwrites them.
struct DenoiserInput {
  Image &film, &noise, &seen, &albedo, &normal, &z, &met;
  Mat3f display_from_world{1.0f};  ///< rotates directions; its scale does not matter
};

/// Denoises frames that are rendered for the same optics.
class Denoiser {
 public:
  /// `optics` must pass validate(). The frames hold rows first_row to end_row - 1 of the film; end_row is limited to the film's
  /// height.
  explicit Denoiser(const Optics& optics, int first_row = 0, int end_row = std::numeric_limits<int>::max());
  ~Denoiser();

  /// Returns the denoised film. Its bits depend neither on the number of threads nor on the processor.
  Image denoise(const DenoiserInput& frame, const ThreadPool& pool) const;

  /// Returns the number of film rows above and below a row that affect its result. A row gets the same bits as in the whole
  /// film if the frame holds this many rows, or all rows up to the film's edge, on both sides. For quilts with several rows of
  /// tiles, the number is the film's height.
  static int rows_around(const Optics& optics);

  /// Working memory per pixel in addition to the frame: two estimates of light, and the film pixel of each view pixel.
  /// Measured: 36 bytes for quilts, 40 for hexagonal lenses.
  static constexpr double kWorkBytesPerPixel = 40.0;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

// Removes the noise of path tracing from a frame of a light field, guided by noise-free features: albedo, normal, depth.
//
// Light is separated from textures (divided by albedo). It is averaged with the light of the same point in neighbouring views,
// found by its depth, and then with its neighbours in the view, over steps of increasing size. The weight of another pixel
// falls with the difference of the surfaces, and with the part of the difference in light that noise does not explain; the
// variance of every pixel is estimated from the two halves of its samples.
//
// All passes are loops over rows of a view, one array per number, that the compiler turns into vector instructions
// (core/multiversion.hpp).
//
// Based on: H. Dammertz et al., "Edge-avoiding a-trous wavelet transform for fast global illumination filtering", HPG 2010
// (steps that double); C. Schied et al., "Spatiotemporal variance-guided filtering", HPG 2017 (light over albedo, weights by
// variance, which is filtered along); F. Rousselle et al., "Adaptive rendering with non-local means filtering", SIGGRAPH Asia
// 2012 (variance from two half buffers; distances less the noise that is expected of them).
// We deviate: (1) views take part in place of frames, so that every frame is denoised by itself; (2) the light that is compared
// is the mean over neighbours on the same surface, not that of single pixels.
#pragma once

#include <limits>
#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// One frame as traced; each image has the film's size: as in trace/noisy_frame.hpp. Denoising overwrites all of them.
struct DenoiserInput {
  Image &film, &noise, &seen, &albedo, &normal, &z, &met;
  Mat3f display_from_world{1.0f};  ///< rotates directions, at any scale
};

class Denoiser {
 public:
  /// `optics` must pass validate(). Frames hold the rows first_row ... end_row - 1 of the film; beyond the film: all that there
  /// are.
  explicit Denoiser(const Optics& optics, int first_row = 0, int end_row = std::numeric_limits<int>::max());
  ~Denoiser();

  /// The frame's film without noise: its bits depend neither on the number of threads nor on the processor.
  Image denoise(const DenoiserInput& frame, const ThreadPool& pool) const;

  /// Rows of the film above and below a row on which its result depends: a row that has so many in the frame, or all that there
  /// are, gets the bits that it has in the whole film. Of a quilt with several rows of tiles: all of the film.
  static int rows_around(const Optics& optics);

  /// Memory beside the frame, measured: two estimates of light, and where the views' pixels lie in the film. 36 for quilts, 40
  /// for hexagonal lenses.
  static constexpr double kWorkBytesPerPixel = 40.0;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

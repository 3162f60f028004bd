// Takes the noise of paths out of a frame of a light field, guided by what is known without noise: albedo, normal, depth.
//
// Light is told from textures (divided by albedo) and averaged with that of the same point in neighbouring views, where its
// depth says it is, and in the frames before and after, where its motion says it is; then with that of its neighbours in the
// view, over ever larger steps. Another pixel counts as far as its surface is the same and its light differs by no more than
// noise explains: the variance of every pixel is estimated from the two halves of its samples. As neighbouring views average
// much the same samples, they also become alike.
//
// Based on: H. Dammertz et al., "Edge-avoiding a-trous wavelet transform for fast global illumination filtering", HPG 2010
// (steps that double); C. Schied et al., "Spatiotemporal variance-guided filtering", HPG 2017 (light over albedo, weights by
// variance, which is filtered along); F. Rousselle et al., "Adaptive rendering with non-local means filtering", SIGGRAPH Asia
// 2012 (variance from two half buffers; distances less the noise that is expected of them).
// We deviate: (1) views and both neighbouring frames take part, frames are not averaged recursively, so that a frame is the
// same wherever a render begins; (2) what is compared is the mean over neighbours of the same surface, not single pixels.
#pragma once

#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// One frame as traced, in the panel's own places, each image of the panel's size: as in trace/noisy_frame.hpp.
struct DenoiserInput {
  const Image &film, &noise, &seen, &albedo, &normal, &z, &met;
  const Image &motion, &motion_after;  ///< 2 channels, pixels of a view: place now - place in the frame before, after
  Mat3f display_from_world{1.0f};      ///< turns directions, at any scale
};

class Denoiser {
 public:
  /// A frame made ready, for itself and its neighbours.
  class Frame;

  /// film: where the views' pixels lie in the panel.
  Denoiser(const Optics& optics, const ViewLayout& film);
  ~Denoiser();

  std::shared_ptr<const Frame> prepare(const DenoiserInput& input, const ThreadPool& pool) const;

  /// The frame's film without noise. before, after: its neighbours; null at an animation's ends. The same bits for any
  /// number of threads.
  Image denoise(const Frame* before, const Frame& now, const Frame* after, const ThreadPool& pool) const;

  /// Memory of a frame made ready, and of making frames ready and denoising beside it, as measured.
  static constexpr double kFrameBytesPerPixel = 104.0, kWorkBytesPerPixel = 81.0;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

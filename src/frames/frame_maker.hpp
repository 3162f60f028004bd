// Makes the frames of an animation in order. Each kind of reuse (Reuse) has its own frame maker.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "frames/frame.hpp"

namespace lippmann {

/// The stage, the pool and the context must outlive the frame maker.
struct MakerParts {
  Stage& stage;
  Sampling sampling;
  const ThreadPool& pool;
  const Context& context;
};

class FrameMaker {
 public:
  virtual ~FrameMaker() = default;

  /// Frame numbers must ascend; gaps do not change any image. The result is incomplete if the context is cancelled.
  virtual RenderedFrame make(int frame) = 0;

  /// Takes a film that is no longer needed, to reuse its memory. Thread-safe.
  virtual void recycle(Image) {}

  virtual std::vector<FrameReport> sources() const { return {}; }
};

/// `params` must pass check(). `stage`, `pool` and `context` must outlive the result. Throws a usage Error if the kind of reuse
/// does not support the scene.
std::unique_ptr<FrameMaker> make_frame_maker(Stage& stage, const FrameParams& params, const ThreadPool& pool,
                                             const Context& context);

/// Returns the working memory in bytes per pixel, without film and layers.
double working_bytes_per_pixel(const FrameParams& params, int frames);

/// Returns the number of frames in a segment, which are made together. If an animation is divided at multiples of this number,
/// each part needs at most one earlier key frame.
int frames_per_segment(const FrameParams& params);

}  // namespace lippmann

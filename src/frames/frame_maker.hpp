// Makes the frames of an animation in order. Each kind of reuse (Reuse) has its own frame maker.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "frames/frame.hpp"

namespace lippmann {

/// Arguments of the constructors of all frame makers. The stage, the pool and the context must outlive the maker.
struct MakerParts {
  Stage& stage;
  Sampling sampling;
  const ThreadPool& pool;
  const Context& context;
};

class FrameMaker {
 public:
  virtual ~FrameMaker() = default;

  /// Makes a frame. Frame numbers must ascend. Skipping frames does not change any image. The result is incomplete if the
  /// context is cancelled meanwhile.
  virtual RenderedFrame make(int frame) = 0;

  /// Takes back the film of a frame that is no longer needed, to reuse its memory. Thread-safe.
  virtual void recycle(Image) {}

  /// Returns the reports of frames that were rendered only as sources of requested frames, in ascending order.
  virtual std::vector<FrameReport> sources() const { return {}; }
};

/// Creates the frame maker for resolved_reuse(). `params` must pass check(). `stage`, `pool` and `context` must outlive the
/// result. Throws a usage Error if the kind of reuse does not support the scene.
std::unique_ptr<FrameMaker> make_frame_maker(Stage& stage, const FrameParams& params, const ThreadPool& pool,
                                             const Context& context);

/// Returns the working memory for `frames` frames, in bytes per pixel. The film and the layers of the current frame are not
/// included.
double working_bytes_per_pixel(const FrameParams& params, int frames);

/// Returns the segment length in frames. Divide an animation only before frames whose number is a multiple of this length. The
/// frames after such a cut then need no earlier frames, or they need one earlier key frame, which is traced for both parts.
/// Cuts do not change any image.
int frames_per_segment(const FrameParams& params);

}  // namespace lippmann

// Makes the frames of an animation one after the other, in the way that the reuse asked for makes them.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "frames/frame.hpp"

namespace lippmann {

/// Arguments of every maker's constructor. The stage, the pool and the context must outlive the maker.
struct MakerParts {
  Stage& stage;
  Sampling sampling;
  const ThreadPool& pool;
  const Context& context;
};

class FrameMaker {
 public:
  virtual ~FrameMaker() = default;

  /// Frames in ascending order; which of them are left out changes no picture. Unfinished when the context was cancelled
  /// meanwhile.
  virtual RenderedFrame make(int frame) = 0;

  /// Takes back the film of a frame that it made and that nobody needs any more: memory for the next. Thread-safe.
  virtual void recycle(Image) {}

  /// What was rendered besides the frames asked for so far, because these are made from it; ascending.
  virtual std::vector<FrameReport> sources() const { return {}; }
};

/// The maker of the kind of reuse that serves (resolved_reuse). `params` passes check(); `stage`, `pool` and `context` outlive
/// the result. Throws a usage Error for scenes that it cannot serve.
std::unique_ptr<FrameMaker> make_frame_maker(Stage& stage, const FrameParams& params, const ThreadPool& pool,
                                             const Context& context);

/// Bytes per pixel that making `frames` frames takes, and keeps from frame to frame, beside the film and layers of the frame
/// that is made.
double working_bytes_per_pixel(const FrameParams& params, int frames);

/// Where an animation is best cut into parts that are rendered apart: before frames whose number is a multiple of this. Frames
/// from there on need none before them, or one key frame that is traced on both sides of the cut. Pictures do not depend on
/// where it is cut.
int frames_per_segment(const FrameParams& params);

}  // namespace lippmann

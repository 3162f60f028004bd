// Makes the frames of an animation one after the other, in the way that the reuse asked for makes them.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "frames/frame.hpp"

namespace lippmann {

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

/// The kind of reuse that serves (resolved_reuse) for a scene: no light is shared where there are splats, whose light it does
/// not know.
Reuse reuse_for(const Scene& scene, const FrameParams& params);

/// The maker of the kind of reuse that serves (reuse_for). `params` passes check(); `stage`, `pool` and `context` outlive
/// the result. Throws a usage Error for scenes that it cannot serve.
std::unique_ptr<FrameMaker> make_frame_maker(Stage& stage, const FrameParams& params, const ThreadPool& pool,
                                             const Context& context);

/// The inputs of a maker's memory estimate, beside its parameters.
struct Workload {
  int animation_frames = 1;  ///< the scene's
  int frames = 1;            ///< that are asked for
  double covered = 1.0;      ///< the share of pixels that see a surface
};

/// Bytes per pixel that making frames takes, and keeps from frame to frame, beside the film and layers of the frame that is
/// made.
double working_bytes_per_pixel(const FrameParams& params, const Workload& work);

/// Where an animation is best cut into parts that are rendered apart: before frames whose number is a multiple of this. Frames
/// from there on need none before them, or one key frame that is traced on both sides of the cut. Pictures do not depend on
/// where it is cut.
int frames_per_segment(const FrameParams& params);

}  // namespace lippmann

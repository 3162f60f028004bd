// Path-traced frames whose soft light is reused: across pixels, views and the frames of a segment.
#pragma once

#include "frames/frame_maker.hpp"
#include "radiance/cached_light.hpp"
#include "reuse/swept_boxes.hpp"

namespace lippmann {

/// Which frames share light.
enum class LightHistory {
  kSegment,  ///< those of a segment
  kFrame,    ///< none: a frame asks for no others, and costs more than most of a segment
};

class SharedLightFrames final : public FrameMaker {
 public:
  SharedLightFrames(Stage& stage, const Sampling& sampling, const ShareLight& reuse, const ThreadPool& pool,
                    const Context& context, LightHistory history = LightHistory::kSegment);

  RenderedFrame make(int frame) override;

  /// The same with what a denoiser wants to know: `pictures` as make() has them, for which layers are wanted; frames in
  /// ascending order.
  FrameReport make_noisy(int frame, FramePictures& pictures, NoisyFrame& noisy);

  /// Whether both frames share light: else they have nothing to do with each other, so that each can be made alone.
  static bool are_of_one_history(int frame, int other);

  /// How many frames a history has.
  static int frames_per_segment();

  /// Earlier frames of a history, where only later ones were asked for.
  std::vector<FrameReport> sources() const override { return sources_; }

 private:
  void go_to(int frame, FramePictures& pictures);
  FrameReport visit(int frame, FramePictures& pictures, NoisyFrame* noisy = nullptr);

  Stage& stage_;
  Sampling sampling_;
  ShareLight reuse_;
  const ThreadPool& pool_;
  const Context& context_;
  SweptBoxes swept_;
  CachedLightTracer tracer_;
  std::vector<FrameReport> sources_;
  const int segment_;  ///< frames that share light with each other: strips of them do not
  int next_ = -1;      ///< the frame that follows what the tracer has seen
};

}  // namespace lippmann

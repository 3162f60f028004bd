// Frames of path-traced light without its noise: each is traced once, kept while its neighbours need it, and filtered together
// with the frames before and after it (denoise/denoiser.hpp).
#pragma once

#include <map>
#include <optional>

#include "denoise/denoiser.hpp"
#include "frames/shared_light_frames.hpp"

namespace lippmann {

class DenoisedFrames final : public FrameMaker {
 public:
  /// light: how frames share light; null: they do not. Where they do, frames of one history have no neighbours in another.
  /// Throws a usage Error where the optics have no views of whole pixels.
  DenoisedFrames(Stage& stage, const Sampling& sampling, const ShareLight* light, const ThreadPool& pool,
                 const Context& context);

  RenderedFrame make(int frame) override;
  std::vector<FrameReport> sources() const override;

  /// Three frames made ready, one as traced, and what filtering takes.
  /// Without what shared light takes.
  static double bytes_per_pixel(const Workload& work);

 private:
  struct Traced {
    std::shared_ptr<const Denoiser::Frame> ready;
    FrameAovs aovs;
    FrameReport report;
  };

  /// Null beyond the animation's ends, and when the context was cancelled meanwhile.
  Traced* traced(int frame);
  FrameReport trace(int frame, const Moment& moment, Traced& made, NoisyFrame& noisy);
  Image motion_from(const Moment& now, int other);

  Stage& stage_;
  Sampling sampling_;
  const ThreadPool& pool_;
  const Context& context_;
  Denoiser denoiser_;
  std::optional<SharedLightFrames> lit_;  ///< none: whole paths
  std::map<int, Traced> traced_;
  std::map<int, FrameReport> unused_;  ///< reports of frames that were traced and not asked for so far
};

}  // namespace lippmann

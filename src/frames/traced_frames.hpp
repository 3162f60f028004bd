// Frames that are traced, each by itself. Path-traced frames are denoised (denoise/denoiser.hpp) if the sampling says so.
#pragma once

#include <optional>

#include "denoise/denoiser.hpp"
#include "frames/frame_maker.hpp"

namespace lippmann {

class TracedFrames final : public FrameMaker {
 public:
  /// `stage`, `pool` and `context` must outlive this object.
  TracedFrames(Stage& stage, const Sampling& sampling, const ThreadPool& pool, const Context& context);

  RenderedFrame make(int frame) override;

  /// Working memory beside the film and the layers.
  static double bytes_per_pixel(const Sampling& sampling);

 private:
  RenderedFrame denoised(int frame);

  Stage& stage_;
  Sampling sampling_;
  const ThreadPool& pool_;
  const Context& context_;
  std::optional<Denoiser> denoiser_;  ///< none: frames stay as traced
};

}  // namespace lippmann

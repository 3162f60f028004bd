// Frames that are traced, each by itself. Path-traced frames are denoised (denoise/denoiser.hpp) if the sampling says so.
#pragma once

#include <optional>

#include "denoise/denoiser.hpp"
#include "frames/frame_maker.hpp"

namespace lippmann {

/// Rows of the film above and below a row on which its pixels depend; all of the film's in a denoised quilt of several rows.
int rows_around(const Sampling& sampling, const Optics& optics);

class TracedFrames final : public FrameMaker {
 public:
  /// `stage`, `pool` and `context` must outlive this object.
  TracedFrames(Stage& stage, const Sampling& sampling, const ThreadPool& pool, const Context& context);

  RenderedFrame make(int frame) override;

  /// Working memory beside the film and the layers.
  static double bytes_per_pixel(const Sampling& sampling);

 private:
  RenderedFrame denoised(int frame);
  void keep_rows(FilmRows rows, FramePictures& pictures) const;

  Stage& stage_;
  Sampling sampling_;
  const ThreadPool& pool_;
  const Context& context_;
  FilmRows traced_rows_;              ///< the stage's, and around them what the denoiser reads
  std::optional<Denoiser> denoiser_;  ///< none: frames stay as traced
};

}  // namespace lippmann

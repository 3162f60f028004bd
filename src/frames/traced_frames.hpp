// Traces every frame separately. Path-traced frames are denoised (denoise/denoiser.hpp) if is_denoised() is true.
#pragma once

#include <optional>

#include "denoise/denoiser.hpp"
#include "frames/frame_maker.hpp"

namespace lippmann {

/// Number of film rows above and below a row that affect its pixels: 0 without denoising, and the film's height for a denoised
/// quilt with several rows of tiles.
int rows_around(const Sampling& sampling, const Optics& optics);

/// Makes frames by tracing all of their pixels.
class TracedFrames final : public FrameMaker {
 public:
  explicit TracedFrames(const MakerParts& parts);

  RenderedFrame make(int frame) override;

  /// Working memory per pixel in addition to the film and the layers, in bytes.
  static double bytes_per_pixel(const Sampling& sampling);

 private:
  RenderedFrame denoised(int frame);
  void keep_rows(FilmRows rows, FramePictures& pictures) const;

  MakerParts parts_;
  FilmRows traced_rows_;              ///< the stage's rows, and those around them that the denoiser reads
  std::optional<Denoiser> denoiser_;  ///< empty: frames are not denoised
};

}  // namespace lippmann

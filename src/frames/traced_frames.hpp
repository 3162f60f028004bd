// Makes frames by tracing all of their pixels. Path-traced frames are denoised (denoise/denoiser.hpp) if is_denoised() is true.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

/// Returns how many rows above and below a row affect its pixels: 0 without denoising, the film's height for a denoised quilt
/// with several rows of tiles.
int rows_around(const Sampling& sampling, const Optics& optics);

std::unique_ptr<FrameMaker> make_traced_frames(const MakerParts& parts);

double traced_frames_bytes_per_pixel(const Sampling& sampling);

}  // namespace lippmann

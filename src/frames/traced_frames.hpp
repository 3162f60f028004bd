// Traces every frame separately. Path-traced frames are denoised (denoise/denoiser.hpp) if is_denoised() is true.
#pragma once

#include <memory>

#include "frames/frame_maker.hpp"

namespace lippmann {

/// Returns the number of film rows above and below a row that affect its pixels. It is 0 without denoising, and the film's
/// height for a denoised quilt with several rows of tiles.
int rows_around(const Sampling& sampling, const Optics& optics);

/// Makes frames by tracing all of their pixels.
std::unique_ptr<FrameMaker> make_traced_frames(const MakerParts& parts);

/// Returns the working memory in bytes per pixel, in addition to the film and the layers.
double traced_frames_bytes_per_pixel(const Sampling& sampling);

}  // namespace lippmann

// A path-traced frame with the inputs of a denoiser: the light, an estimate of its noise, and noise-free properties of the
// surfaces.
#pragma once

#include <array>
#include <bit>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// All images are means over the samples of a pixel, so edges are antialiased as in the film. Albedo, normal, z and met
/// describe the first surface on each camera ray that scatters light. Where alpha makes a surface transparent, the ray passes
/// it.
struct NoisyFrame {
  Image film;    ///< 3 channels: light
  Image noise;   ///< 3 channels: half the difference between the means of two halves of the samples, which estimates the error
  Image seen;    ///< 3 channels: background and emission seen directly or behind holes, which have no path-tracing noise
  Image albedo;  ///< 3 channels: base colour; 0 without a surface
  Image normal;  ///< 3 channels: normal in world space; shorter than 1 if the samples' normals differ
  Image z;       ///< 1 channel: z in mm of the display frame, 0 without a surface; z / met is the mean z of the surfaces
  Image met;     ///< 1 channel: share of the samples that hit a surface
};

/// Returns whether a sample belongs to the second half of a pixel's samples: those whose number has an odd number of binary
/// ones. If a pixel has 2^k samples, both halves cover the pixel and the directions equally well.
inline bool is_of_second_half(std::uint32_t sample) { return (std::popcount(sample) & 1) != 0; }

/// Returns the weights in NoisyFrame::noise of samples from the first and from the second half, relative to their weight in the
/// film.
std::array<float, 2> weights_of_halves(int spp);

/// Size of the images of a NoisyFrame, in bytes per pixel.
inline constexpr double kNoisyFrameBytesPerPixel = 17 * sizeof(float);

/// Traces a frame as trace_frame() does, and also fills the inputs of a denoiser. The scene must be built for path tracing,
/// with at least 2 samples per pixel. noisy.film is bit-identical to the film of trace_frame().
RayCounts trace_noisy_frame(const Shot& shot, const TraceParams& params, const Workers& workers, NoisyFrame& noisy,
                            FrameAovs& aovs, SampleShare share = {});

}  // namespace lippmann

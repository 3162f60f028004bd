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
  Image noise;   ///< 3 channels: error estimate: half the difference of the means of the samples' first and second half
  Image seen;    ///< 3 channels: noise-free part of the light: background and emission seen directly or through holes
  Image albedo;  ///< 3 channels: base colour; 0 without a surface
  Image normal;  ///< 3 channels: normal in world space; shorter than 1 if the samples' normals differ
  Image z;       ///< 1 channel: z in mm of the display frame, 0 without a surface; z / met is the mean z of the surfaces
  Image met;     ///< 1 channel: share of the samples that hit a surface
};

/// Returns whether a sample belongs to the second half of a pixel's samples. The second half consists of the sample numbers
/// with an odd count of 1 bits. If a pixel has 2^k samples, both halves cover the pixel and the directions equally well.
inline bool is_of_second_half(std::uint32_t sample) { return (std::popcount(sample) & 1) != 0; }

/// Returns two factors, for samples of the first and of the second half. A sample is added to NoisyFrame::noise with its weight
/// in the film times this factor.
std::array<float, 2> weights_of_halves(int spp);

/// Size of the images of a NoisyFrame, in bytes per pixel.
inline constexpr double kNoisyFrameBytesPerPixel = 17 * sizeof(float);

/// Traces a frame as trace_frame() does, and also fills the inputs of a denoiser. The scene must be built for path tracing,
/// with at least 2 samples per pixel. noisy.film is bit-identical to the film of trace_frame().
RayCounts trace_noisy_frame(const Shot& shot, const TraceParams& params, const Workers& workers, NoisyFrame& noisy,
                            FrameAovs& aovs, SampleShare share = {});

}  // namespace lippmann

// A path-traced frame with the inputs of the denoiser: its light, an estimate of the noise, and noise-free surface features.
#pragma once

#include <array>
#include <bit>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// All images are means over the samples of each pixel, so edges are antialiased like those of the film. Albedo, normal, z and
/// met describe the first surface on each camera ray that scatters light. Surfaces count as not hit where alpha makes them
/// transparent.
struct NoisyFrame {
  Image film;    ///< 3 channels: all light
  Image noise;   ///< 3 channels: half the difference between the means of two halves of the samples; an estimate of the error
  Image seen;    ///< 3 channels: background, and emission of the first surface; free of path-tracing noise
  Image albedo;  ///< 3 channels: base colour, 0 without a surface
  Image normal;  ///< 3 channels: world space; shorter than 1 if the samples differ
  Image z;       ///< 1 channel: in display mm, 0 without a surface; divide by `met` to get the depth of the surface
  Image met;     ///< 1 channel: share of the samples that hit a surface
};

/// Returns whether a sample belongs to the second half of a pixel's samples. The second half has the sample numbers with an odd
/// number of binary ones. For 2^k samples, both halves cover the pixel and the directions equally well.
inline bool is_of_second_half(std::uint32_t sample) { return (std::popcount(sample) & 1) != 0; }

/// Returns the weights of samples of the first and the second half in NoisyFrame::noise, relative to a sample's weight in the
/// film.
std::array<float, 2> weights_of_halves(int spp);

/// Memory of the images of a NoisyFrame, in bytes per pixel.
inline constexpr double kNoisyFrameBytesPerPixel = 17 * sizeof(float);

/// Traces a frame like trace_frame() and also fills the inputs of the denoiser. The scene must be built for path tracing, with
/// at least 2 samples per pixel. noisy.film is bit-identical to the film of trace_frame().
RayCounts trace_noisy_frame(const Shot& shot, const TraceParams& params, const Workers& workers, NoisyFrame& noisy,
                            FrameAovs& aovs, SampleShare share = {});

}  // namespace lippmann

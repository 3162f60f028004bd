// A path-traced frame with the inputs of a denoiser.
#pragma once

#include <array>
#include <bit>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// All images are means over the samples of a pixel. Albedo, normal, z and met describe the first opaque surface on each camera
/// ray that scatters light.
struct NoisyFrame {
  Image film;
  Image noise;  ///< 3 channels: half the difference between the means of the samples' two halves, which estimates the error
  Image seen;   ///< 3 channels: noise-free light: background and emission that the camera sees directly
  Image albedo;
  Image normal;
  Image z;  ///< 1 channel: mean of z in mm of the display frame, with 0 for samples without a surface; z / met is the surfaces'
            ///< mean z
  Image met;  ///< 1 channel: fraction of the samples that hit a surface
};

/// Splits a pixel's samples into two halves by the parity of the sample number's 1 bits. Both halves of 2^k samples cover the
/// pixel evenly.
inline bool is_of_second_half(std::uint32_t sample) { return (std::popcount(sample) & 1) != 0; }

/// Returns the factors for samples of the first and of the second half. With these factors, a pixel's samples add up to
/// NoisyFrame::noise.
std::array<float, 2> weights_of_halves(int spp);

inline constexpr double kNoisyFrameBytesPerPixel = 17 * sizeof(float);

/// Traces a frame as trace_frame() does, with the inputs of a denoiser. Needs a scene for path tracing and at least 2 samples
/// per pixel. noisy.film is bit-identical to the film of trace_frame().
RayCounts trace_noisy_frame(const Shot& shot, const TraceParams& params, const Workers& workers, NoisyFrame& noisy,
                            FrameAovs& aovs, SampleShare share = {});

}  // namespace lippmann

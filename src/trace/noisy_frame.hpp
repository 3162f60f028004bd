// A path-traced frame as a denoiser wants it: its light, how noisy it is, and what is known of the surfaces without noise.
#pragma once

#include <array>
#include <bit>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Means over the samples of every pixel, so that edges are as smooth here as in the film. Surfaces are those that a camera ray
/// meets first and that scatter light; what alpha does not cover counts as not met.
struct NoisyFrame {
  Image film;    ///< 3 channels: all light
  Image noise;   ///< 3 channels: half of what the means of two halves of the samples differ by: of the film's error's size
  Image seen;    ///< 3 channels: the part that has met no surface, or shines from the first: free of the noise of paths
  Image albedo;  ///< 3 channels: base colour, 0 where no surface was met
  Image normal;  ///< 3 channels: world space; shorter than 1 where samples differ
  Image z;       ///< 1 channel: in display mm, 0 where no surface was met: to be divided by `met`
  Image met;     ///< 1 channel: share of samples that met a surface
};

/// Which of two halves of a pixel's samples each belongs to: that with an even or an odd number of binary ones. Each half of
/// 2^k samples is then spread over the pixel and over directions as evenly as the other.
inline bool is_of_second_half(std::uint32_t sample) { return (std::popcount(sample) & 1) != 0; }

/// With which the light of samples of either half, each 1 / spp of the film's, adds up to NoisyFrame::noise.
std::array<float, 2> weights_of_halves(int spp);

/// What the images of a NoisyFrame take.
inline constexpr double kNoisyFrameBytesPerPixel = 17 * sizeof(float);

/// As trace_frame for the same scene, made for paths, at 2 or more samples per pixel: noisy.film has the bits of its film.
RayCounts trace_noisy_frame(const Shot& shot, const TraceParams& params, const Workers& workers, NoisyFrame& noisy,
                            FrameAovs& aovs, SampleShare share = {});

}  // namespace lippmann

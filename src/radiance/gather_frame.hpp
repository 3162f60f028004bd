// All pixels of a frame by cached light: a few samples each, more of them where they differ.
#pragma once

#include <functional>
#include <limits>
#include <span>

#include "radiance/final_gather.hpp"
#include "radiance/path_mix.hpp"
#include "trace/noisy_frame.hpp"
#include "trace/packet_source.hpp"

namespace lippmann {

/// How much is done for a picture.
struct GatherEffort {
  float error = 0.01f;  ///< standard deviation of a sample, as sRGB's codes (0 ... 1) have it, at which one is enough
  EdgesToPaths edges = EdgesToPaths::kNone;
  PathMix mix{};
  /// What a single pixel may be expected to err by at most, squared. The mean is least where few pixels err by much, and jagged
  /// edges are what eyes see first.
  float worst = std::numeric_limits<float>::infinity();
};

struct GatherParams {
  TraceParams trace;  ///< spp is not used: samples are as many as `effort.error` asks for
  GatherEffort effort;
  bool provenance = false;  ///< see FinalGatherOptions
};

/// By how much the samples of each pixel scatter, as sRGB's codes have it, squared; by pixel index, < 0: not known of this one.
/// Empty: not known of any pixel.
using Scatter = std::vector<float>;

/// For each pixel half itself, as what stands still scatters again, and half the mean of those near by, in its own view and in
/// neighbouring ones: a few samples' scatter is mostly chance, and what moves a little from frame to frame stays within.
Scatter smoothed(const Scatter& scatter, const Optics& optics, const ThreadPool& pool);

/// Samples of a pixel at most.
inline constexpr int kMostGatherSamples = 128;

/// What a frame is gathered from. Outlives the calls that it is given to.
struct GatherSources {
  Shot shot;
  const CacheCells& cells;
  const RadianceCache& cache;
};

/// What is known of the pixels that are to be gathered.
struct GatherHistory {
  const Scatter* before = nullptr;  ///< scatter in the frame before, smoothed: pixels scatter as much again; null: not known
  Scatter* now = nullptr;           ///< receives what this frame finds, of the gathered pixels; null: nobody asks
  /// Receives the squared error that the scatter of samples, and their number, lead to expect of pixels, on average. It is in
  /// no absolute terms: what light that is wrong adds is not in it, nor all that even spreading takes away. Null: nobody asks.
  double* expected = nullptr;
};

/// Where a gathered frame goes.
struct GatheredPictures {
  Image& film;
  Image* alpha = nullptr;       ///< receives Aov::kAlpha, and the film is free of the surroundings; else null
  NoisyFrame* noisy = nullptr;  ///< whole frames only: receives what a denoiser wants to know beside the film; else null
  Image* provenance = nullptr;  ///< receives Aov::kProvenance; else null
};

/// Fills pictures.film (3 channels, linear, the panel's size), or of it only the packets that are not 0 in `wanted` (by packet,
/// as in trace_packets; empty: all). pictures.alpha has the film's size and 1 channel. The same bits for any number of threads.
/// Returns early when the context is cancelled.
RayCounts gather_frame(const GatherSources& sources, const GatherParams& params, std::span<const std::uint8_t> wanted,
                       const GatherHistory& history, const Workers& workers, const GatheredPictures& pictures);

/// Packets of a frame, as trace_packets and gather_frame count them.
struct FramePackets {
  std::size_t strips, per_strip;
};
FramePackets packets_in_frame(const PacketSource& source);

/// Appends the pixels of packets first ... end - 1, all of one strip.
void append_pixels(const PacketSource& source, std::size_t first, std::size_t end, std::vector<std::uint32_t>& pixels);

/// Calls fn(packet, pixel) for all pixels of a frame.
void for_each_pixel(const PacketSource& source, const std::function<void(std::size_t, std::uint32_t)>& fn);

}  // namespace lippmann

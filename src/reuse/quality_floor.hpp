// Traces as much of a predicted frame as is needed to keep its PSNR at or above a floor.
//
//   1. The errors of patches by level of uncertainty come from a nearby frame that was predicted and completely traced
//      (learn_floor), and from held-out patches of this frame, which are traced. Together they bound with 95 % confidence the
//      error that each level leaves in the frame (held_out.hpp).
//   2. As many of the lowest levels as possible are trusted. Both their bound and the error estimated from this frame's own
//      sample must stay within the mean squared error that the floor allows. All other patches are traced.
//   3. If that would cost about as much as the whole frame, tracing stops, because it is better to trace the frame
//      completely.
// The selection depends only on the predictions, the keys' rays, the seed and the frame's number.
#pragma once

#include <span>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/encoding.hpp"
#include "reuse/held_out.hpp"
#include "reuse/patches.hpp"
#include "reuse/retrace.hpp"

namespace lippmann {

struct FloorParams {
  double min_psnr_db = 0.0;  ///< lower limit for every frame, in 8-bit display codes; finite
  std::uint32_t seed = 0;    ///< decides which patches are held out
};

/// A frame is traced completely if its untrusted patches would cost more than this, in traced frames (tracing_costs.hpp).
inline constexpr double kMostCost = 0.9;

/// The description of a predicted frame, without its film.
struct Predicted {
  int number;                                 ///< number in the animation
  std::span<const std::uint8_t> uncertainty;  ///< by pixel
  const Patches& patches;                     ///< the division of its pixels into patches
  std::span<const float> costs;               ///< by patch (Patches::costs)
  Encoding encoding;                          ///< encoding of the codes whose errors are measured
};

/// The errors and costs learned from a frame that was both predicted and completely traced.
struct FloorLesson {
  Evidence evidence;
  double cost = 1.0;  ///< cost of tracing part of a similar frame, including held-out patches; in traced frames
};

FloorLesson learn_floor(const FloorParams& params, const Predicted& frame, const Image& predicted, const Image& traced,
                        const ThreadPool& pool);

struct FloorOutcome {
  bool holds = false;          ///< false: trace the frame completely
  std::uint64_t retraced = 0;  ///< number of pixels traced here, including held-out ones
  ErrorEstimate error;         ///< estimated error of the finished frame, if `holds`
};

/// `film` is the prediction on entry and the finished frame on return. `learned` must come from a frame predicted over at least
/// the same time.
FloorOutcome hold_floor(const FloorParams& params, const Predicted& frame, const Evidence& learned, const TracePackets& trace,
                        const ThreadPool& pool, Image& film);

}  // namespace lippmann

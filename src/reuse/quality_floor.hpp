// Traces of a predicted frame what has to be traced for its PSNR to stay at or above a floor.
//
//   1. What patches of each level of uncertainty err by is known from a frame near by that was predicted and traced as a whole
//      (learn_floor), and from held-out patches of this frame, which are traced. Both together bound with 95 % confidence what
//      each level leaves in the frame (held_out.hpp).
//   2. The most levels, from the lowest on, that keep the bound within the floor's mean squared error, and whose errors by this
//      frame's own sample do so too, are trusted; all other patches are traced.
//   3. Where that would cost about as much as all of the frame, nothing more is: it is better traced as a whole.
// Which patches are traced depends on the predictions, the keys' rays, the seed and the frame's number alone.
#pragma once

#include <span>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/encoding.hpp"
#include "reuse/held_out.hpp"
#include "reuse/patches.hpp"
#include "reuse/retrace.hpp"

namespace lippmann {

struct FloorParams {
  double min_psnr_db = 0.0;  ///< a floor for every frame, in 8-bit display codes; finite
  std::uint32_t seed = 0;    ///< decides which patches are held out
};

/// Frames whose other patches would cost more than this, in traced frames (tracing_costs.hpp), are not made from others.
inline constexpr double kMostCost = 0.9;

/// What is known of a predicted frame but its film.
struct Predicted {
  int number;                                 ///< in the animation
  std::span<const std::uint8_t> uncertainty;  ///< by pixel
  const Patches& patches;                     ///< which its pixels are divided into
  std::span<const float> costs;               ///< by patch (Patches::costs)
  Encoding encoding;                          ///< of the codes whose errors are meant
};

/// What a frame that was predicted and traced as a whole tells about others.
struct FloorLesson {
  Evidence evidence;
  double cost = 1.0;  ///< what tracing part of a frame like it would cost, held-out patches included; in traced frames
};

FloorLesson learn_floor(const FloorParams& params, const Predicted& frame, const Image& predicted, const Image& traced,
                        const ThreadPool& pool);

struct FloorOutcome {
  bool holds = false;          ///< false: the frame is to be traced as a whole
  std::uint64_t retraced = 0;  ///< pixels traced here, held-out ones among them
  ErrorEstimate error;         ///< what the finished frame errs by, where the floor holds
};

/// `film` is the prediction, then the finished frame. `learned` is of a frame predicted over no shorter a time.
FloorOutcome hold_floor(const FloorParams& params, const Predicted& frame, const Evidence& learned, const TracePackets& trace,
                        const ThreadPool& pool, Image& film);

}  // namespace lippmann

// Traces as much of a predicted frame as necessary so that its PSNR reaches a lower limit (the floor).
//
//   1. Measure the error for every level of uncertainty, in a nearby frame that was both predicted and completely traced
//      (learn_floor), and in a sample of this frame's patches, which are traced. held_out.hpp computes an upper bound of the
//      error with 95 % confidence.
//   2. Trace the patches with the highest uncertainty, and keep the predictions of all others. Trace as few patches as possible
//      such that the upper bound and the error estimated from the sample are both within the error that the floor allows.
//   3. If step 2 would cost about as much as the whole frame, stop. The caller then traces the whole frame.
// The choice depends only on the predictions, the ray counts of the key frames, the seed and the frame's number.
#pragma once

#include <span>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/encoding.hpp"
#include "reuse/held_out.hpp"
#include "reuse/patches.hpp"
#include "reuse/retrace.hpp"

namespace lippmann {

struct FloorParams {
  double min_psnr_db = 0.0;  ///< lowest accepted PSNR of each frame, computed from 8-bit display codes; must be finite
  std::uint32_t seed = 0;
};

/// If tracing a part of a frame costs more than this fraction of the cost of the whole frame, the whole frame is traced.
inline constexpr double kMostCost = 0.9;

struct Predicted {
  int number;
  std::span<const std::uint8_t> uncertainty;
  const Patches& patches;
  std::span<const float> costs;  ///< cost of tracing each patch (Patches::costs)
  Encoding encoding;
};

struct FloorLesson {
  Evidence evidence;
  /// Cost of tracing the patches that the floor requires in a similar frame, relative to the whole frame.
  double cost = 1.0;
};

FloorLesson learn_floor(const FloorParams& params, const Predicted& frame, const Image& predicted, const Image& traced,
                        const ThreadPool& pool);

struct FloorOutcome {
  bool holds = false;  ///< if false, the caller must trace the whole frame
  std::uint64_t retraced = 0;
  ErrorEstimate error;  ///< estimated error of the frame; only set if `holds` is true
};

/// Traces part of a frame so that it reaches the floor. `film` holds the prediction, and on return the result. `learned` must
/// come from a frame whose two key frames are at least as far apart in time as the key frames of this frame.
FloorOutcome hold_floor(const FloorParams& params, const Predicted& frame, const Evidence& learned, const TracePackets& trace,
                        const ThreadPool& pool, Image& film);

}  // namespace lippmann

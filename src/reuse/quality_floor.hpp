// Traces of a predicted frame what has to be traced for its PSNR to stay at or above a floor.
//
//   1. Held-out patches of every level of doubt are traced; their errors bound, with 95 % confidence, what each level leaves in
//      the frame (held_out.hpp).
//   2. The most levels, from the lowest on, that keep the bound within the floor's mean squared error are trusted; all other
//      patches are traced.
//   3. Where that would be most of the frame, nothing more is: the frame is better traced as a whole.
// Which patches are traced depends on the prediction, the seed and the frame's number alone.
#pragma once

#include <span>

#include "core/parallel.hpp"
#include "image/encoding.hpp"
#include "reuse/held_out.hpp"
#include "reuse/patches.hpp"
#include "reuse/retrace.hpp"

namespace lippmann {

struct FloorParams {
  double min_psnr_db = 0.0;  ///< of a frame in 8-bit display codes; finite
  std::uint32_t seed = 0;    ///< of the choice of held-out patches
};

/// Frames of which a larger share would have to be traced are not made from others: what is doubted is dearer to trace than
/// other pixels (edges, mirrors), and projection has its price.
inline constexpr double kMostRetraced = 0.5;

struct FloorOutcome {
  bool holds = false;           ///< false: the frame is to be traced as a whole
  double share_to_trace = 1.0;  ///< of the frame's patches, held-out ones aside; decides the former
  std::uint64_t retraced = 0;   ///< pixels traced here, held-out ones among them
  ErrorEstimate error;          ///< of the finished frame; where it holds
};

/// `film` is the prediction, then the finished frame. `doubt` is of its pixels.
FloorOutcome hold_floor(const FloorParams& params, std::span<const std::uint8_t> doubt, const Patches& patches, int frame,
                        Encoding encoding, const TracePackets& trace, const ThreadPool& pool, Image& film);

}  // namespace lippmann

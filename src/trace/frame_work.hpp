// Selects and groups the packets of a frame that are traced.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "lippmann/trace/ray_counts.hpp"
#include "trace/packet_source.hpp"
#include "trace/sample_share.hpp"
#include "trace/shot.hpp"

namespace lippmann {

/// Selects the blocks (see touched_blocks.hpp) or packets (see trace_packets.hpp) with a nonzero entry in `wanted`. If `wanted`
/// is empty, all are selected.
struct FrameWork {
  enum class Unit { kBlocks, kPackets };
  Unit unit = Unit::kBlocks;
  std::span<const std::uint8_t> wanted{};
};

inline std::size_t blocks_in(int packets) {
  return static_cast<std::size_t>((packets + kPacketsPerBlock - 1) / kPacketsPerBlock);
}

/// Calls trace(packets, block) for groups of at most kPacketsPerBlock selected packets. `packets` holds packet indices within
/// the strip, and `block` is the index of the block in the frame.
template <class Trace>
void for_each_batch(const FrameWork& work, std::size_t strip, int packets_per_strip, const Trace& trace) {
  std::array<int, kPacketsPerBlock> batch;
  if (work.unit == FrameWork::Unit::kPackets && !work.wanted.empty()) {
    const std::uint8_t* wanted = work.wanted.data() + strip * static_cast<std::size_t>(packets_per_strip);
    std::size_t size = 0;
    for (int p = 0; p < packets_per_strip; ++p) {
      if (wanted[p]) batch[size++] = p;
      if (size < (p + 1 < packets_per_strip ? batch.size() : 1)) continue;
      trace(std::span<const int>(batch.data(), size), strip * blocks_in(packets_per_strip));
      size = 0;
    }
    return;
  }
  for (std::size_t b = 0; b < blocks_in(packets_per_strip); ++b) {
    const std::size_t block = strip * blocks_in(packets_per_strip) + b;
    if (!work.wanted.empty() && !work.wanted[block]) continue;
    const int first = static_cast<int>(b) * kPacketsPerBlock;
    std::iota(batch.begin(), batch.end(), first);
    trace(std::span<const int>(batch.data(), static_cast<std::size_t>(std::min(kPacketsPerBlock, packets_per_strip - first))),
          block);
  }
}

/// Calls trace(strip) for all strips in parallel, until cancellation. Returns the sum of the ray counts. If the samples are
/// traced in several passes, `share` states which pass this is, so that the reported progress covers all passes.
template <class Trace>
RayCounts trace_strips(std::size_t strips, const Workers& workers, const Trace& trace, SampleShare share = {}) {
  std::vector<RayCounts> counts(strips);
  std::atomic<std::size_t> done{0};
  const Context& context = workers.context;
  workers.pool.for_each(strips, [&](std::size_t strip) {
    if (!context.cancelled) counts[strip] = trace(strip);
    const std::size_t finished = ++done;
    if (workers.progress == Progress::kReported && context.frame_progress)
      context.frame_progress(share.progress(static_cast<double>(finished) / static_cast<double>(strips)));
  });
  RayCounts total;
  for (const RayCounts& c : counts) add(c, total);
  return total;
}

}  // namespace lippmann

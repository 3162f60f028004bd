// Traces single pixels of a frame when the others are reused from other frames.
#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces exactly `pixels` (indices y * width + x, strictly ascending). The result is bit-identical to trace_frame(). Writes
/// into `film` (3 channels, the panel's size) and, if given, `points`; other pixels stay unchanged. Packets follow the ray
/// order, so the pixels of a strip and view stay together. The result does not depend on the number of threads. After
/// cancellation it returns early with some pixels unfinished. `open` has the meaning of PathFilm::open and hides the
/// surroundings; null: they are visible.
RayCounts trace_pixels(const Shot& shot, const TraceParams& params, std::span<const std::uint32_t> pixels,
                       const Workers& workers, Image& film, PrimaryPoints* points = nullptr, float* open = nullptr);

}  // namespace lippmann

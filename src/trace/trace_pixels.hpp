// Traces single pixels of a frame: what is left when the others are reused from other frames.
#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces exactly `pixels` (indices y * width + x, strictly ascending) as trace_frame would, to the same bits, and writes them
/// into `film` (3 channels, the panel's size) and, where given, `points`; everything else in both stays as it is.
/// The pixels are packed into packets in the ray order's own sequence, so that those of one strip and view travel together.
/// The same bits for any number of threads. Returns early, some pixels unfinished, when context.cancelled is set.
/// open: as PathFilm::open, so that the surroundings are not seen; null: they are.
RayCounts trace_pixels(const Shot& shot, const TraceParams& params, std::span<const std::uint32_t> pixels,
                       const Workers& workers, Image& film, PrimaryPoints* points = nullptr, float* open = nullptr);

}  // namespace lippmann

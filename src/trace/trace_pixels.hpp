#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces exactly the listed pixels (y * width + x, ascending), bit-identical to trace_frame(). Writes to `film` (3 channels,
/// the size of the panel) and, unless null, to `points`. Other pixels keep their content. After cancellation, returns early.
/// `open` is PathFilm::open; if it is not null, the film omits the background.
RayCounts trace_pixels(const Shot& shot, const TraceParams& params, std::span<const std::uint32_t> pixels,
                       const Workers& workers, Image& film, PrimaryPoints* points = nullptr, float* open = nullptr);

}  // namespace lippmann

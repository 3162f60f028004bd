// Traces single pixels of a frame, while other pixels are copied or interpolated from other frames.
#pragma once

#include <cstdint>
#include <span>

#include "trace/trace_frame.hpp"

namespace lippmann {

/// Traces exactly the listed pixels, given as indices y * width + x in ascending order without repetition. They are
/// bit-identical to those of trace_frame(). Writes to `film` (3 channels, the size of the panel) and, unless null, to `points`.
/// Other pixels keep their content.
/// Packets follow the ray order, so that the pixels of a strip and of a view stay together. The result does not depend on the
/// number of threads. After cancellation, returns early with some pixels unfinished. `open` is PathFilm::open; if it is not
/// null, the film omits the background.
RayCounts trace_pixels(const Shot& shot, const TraceParams& params, std::span<const std::uint32_t> pixels,
                       const Workers& workers, Image& film, PrimaryPoints* points = nullptr, float* open = nullptr);

}  // namespace lippmann

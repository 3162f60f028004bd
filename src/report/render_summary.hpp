// Summary figures of a whole render, with the same names in single reports and comparisons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

struct SummaryFigure {
  std::string name, value;  ///< plain text; a dash if unknown
  std::string why;          ///< one sentence; may be empty
};

/// Returns the same figures in the same order for every render.
std::vector<SummaryFigure> render_summary(const RenderFigures& render);

/// Returns the CPU seconds of all frames and source frames, divided by the number of frames; none without frames.
std::optional<double> cpu_seconds_a_frame(const RenderFigures& render);

/// Returns the share of CPU time saved by reuse relative to fully traced frames, with source frames counted. None if no frame
/// or every frame was fully traced.
std::optional<double> total_saving(const RenderFigures& render);

/// Returns the frame with the lowest PSNR (sure_psnr_db); null if no frame has one.
const FrameReport* worst_frame(const RenderFigures& render);

}  // namespace lippmann

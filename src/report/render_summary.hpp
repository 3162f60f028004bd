// Summary figures of a whole render, with the same names in single reports and comparisons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

struct SummaryFigure {
  std::string name, value;  ///< plain text; an unknown value is a dash
  std::string why;          ///< explanation in one sentence; may be empty
};

/// Returns the summary figures. They are the same, in the same order, for every render.
std::vector<SummaryFigure> render_summary(const RenderFigures& render);

/// Returns the CPU seconds of all frames and source frames, divided by the number of frames; none without frames.
std::optional<double> cpu_seconds_a_frame(const RenderFigures& render);

/// Returns the share of CPU time that reuse saved, compared with tracing all frames fully. The time of source frames is
/// included. None if no frame or every frame was fully traced.
std::optional<double> total_saving(const RenderFigures& render);

/// Returns the frame with the lowest PSNR (sure_psnr_db); null if no frame has one.
const FrameReport* worst_frame(const RenderFigures& render);

}  // namespace lippmann

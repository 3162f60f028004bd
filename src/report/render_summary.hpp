// Summary figures of a whole render. Reports of single renders and comparisons show them with the same names.
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

/// Returns the summary figures. Every render has the same figures in the same order.
std::vector<SummaryFigure> render_summary(const RenderFigures& render);

/// Returns the CPU seconds of all frames and source frames, divided by the number of frames. Returns nullopt without frames.
std::optional<double> cpu_seconds_a_frame(const RenderFigures& render);

/// Returns the share of CPU time that reuse saved, compared with tracing all frames fully. The time of source frames is
/// included. Returns nullopt if no frame or every frame was fully traced.
std::optional<double> total_saving(const RenderFigures& render);

/// Returns the frame with the lowest PSNR (sure_psnr_db()). Returns null if no frame has a PSNR.
const FrameReport* worst_frame(const RenderFigures& render);

}  // namespace lippmann

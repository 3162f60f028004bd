// Summary of a whole render, with the same names in reports of one render and in comparisons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

struct SummaryFigure {
  std::string name, value;  ///< plain text; an unknown value is a dash
  std::string why;
};

std::vector<SummaryFigure> render_summary(const RenderFigures& render);

/// Returns the CPU time of all frames and source frames, divided by the number of frames; nullopt without frames.
std::optional<double> cpu_seconds_a_frame(const RenderFigures& render);

/// Returns the fraction of CPU time that reuse saved, compared to tracing all frames fully. Returns nullopt if no frame or
/// every frame was fully traced.
std::optional<double> total_saving(const RenderFigures& render);

/// Returns the frame with the lowest sure_psnr_db(), or null if none has a PSNR.
const FrameReport* worst_frame(const RenderFigures& render);

}  // namespace lippmann

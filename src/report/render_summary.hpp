// The figures of a whole render, each in one word or number, by the same names alone and in comparisons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

struct SummaryFigure {
  std::string name, value;  ///< plain text; a figure that is not known is a dash
  std::string why;          ///< one sentence; empty: nothing more to say
};

/// Always the same figures in the same order.
std::vector<SummaryFigure> render_summary(const RenderFigures& render);

/// CPU seconds of all frames and of those that they are made from, by the number of frames; none: there is no frame.
std::optional<double> cpu_seconds_a_frame(const RenderFigures& render);

/// What reuse saved in all beside frames traced whole, source frames included; none where none was
/// traced whole, or all were.
std::optional<double> total_saving(const RenderFigures& render);

/// The frame whose quality is the least sure; null: none is estimated.
const FrameReport* worst_frame(const RenderFigures& render);

}  // namespace lippmann

// Compares renders side by side: a table with one row per figure and one column per render, and charts with one line per
// render.
#pragma once

#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

/// Returns the HTML for two or more renders. names: one per render, plain text. Savings are relative to the first render.
/// States what makes the comparison inexact, such as different scenes, frames, sizes or machines.
std::string comparison_section(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

}  // namespace lippmann

// Compares renders: a table with a column per render, and charts with a line per render.
#pragma once

#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

/// Returns the HTML for two or more renders, named `names`. Savings are relative to the first render. The HTML also lists
/// reasons why the comparison is inexact, such as different scenes, sizes or machines.
std::string comparison_section(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

}  // namespace lippmann

// Compares renders side by side. A table has one row per figure and one column per render. Charts have one line per render.
#pragma once

#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

/// Returns the HTML for two or more renders. `names` holds one plain-text name per render. Savings are relative to the first
/// render. The section states what makes the comparison inexact, such as different scenes, frames, sizes or machines.
std::string comparison_section(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

}  // namespace lippmann

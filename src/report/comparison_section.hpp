// Several renders side by side: one row a figure, one column a render, and one line a render in charts over frames.
#pragma once

#include <string>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

/// HTML. At least two renders; `names`: one each, plain text. Savings are beside the first. What makes the comparison less than
/// fair (other scenes, frames, sizes, machines) is said.
std::string comparison_section(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names);

}  // namespace lippmann

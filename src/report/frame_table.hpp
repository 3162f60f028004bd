// A table of all figures of all frames of a render. The page shows it collapsed at first.
#pragma once

#include <string>

#include "report/render_figures.hpp"

namespace lippmann {

/// Returns the HTML of the table. Returns an empty string if there are no frames.
std::string frame_table(const RenderFigures& render);

}  // namespace lippmann

// A table of all values of all frames of a render, which the page shows collapsed at first.
#pragma once

#include <string>

#include "report/render_figures.hpp"

namespace lippmann {

std::string frame_table(const RenderFigures& render);

}  // namespace lippmann

// Every figure of every frame of a render, in a table that is folded until somebody wants it.
#pragma once

#include <string>

#include "report/render_figures.hpp"

namespace lippmann {

/// HTML; empty where there are no frames.
std::string frame_table(const RenderFigures& render);

}  // namespace lippmann

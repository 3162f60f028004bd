// A table of all figures of all frames of a render, folded by default.
#pragma once

#include <string>

#include "report/render_figures.hpp"

namespace lippmann {

/// Returns HTML; empty without frames.
std::string frame_table(const RenderFigures& render);

}  // namespace lippmann

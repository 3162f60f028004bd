// What a page says of one render: figures in all, how it was made, pictures, charts over its frames, and every figure in
// tables.
#pragma once

#include <string>

#include "report/render_figures.hpp"
#include "report/thumbnails.hpp"

namespace lippmann {

/// HTML.
std::string render_section(const RenderFigures& render, const Thumbnails& thumbnails);

}  // namespace lippmann

// The section of a page about one render: summary, settings, images, charts and tables.
#pragma once

#include <string>

#include "report/render_figures.hpp"
#include "report/thumbnails.hpp"

namespace lippmann {

std::string render_section(const RenderFigures& render, const Thumbnails& thumbnails);

}  // namespace lippmann

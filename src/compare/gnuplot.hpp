// Draws charts with the program gnuplot.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lippmann {

std::string gnuplot_quoted(const std::string& text);

/// Writes a PNG file of 960 x 540 pixels. Throws Error if gnuplot is not installed or fails, or if the file cannot be written.
void draw_with_gnuplot(const std::filesystem::path& picture, const std::string& commands);

}  // namespace lippmann

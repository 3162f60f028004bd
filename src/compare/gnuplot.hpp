// Draws pictures with the program gnuplot.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lippmann {

/// A string in gnuplot's single quotes, where only the quote itself is special.
std::string gnuplot_quoted(const std::string& text);

/// Runs a script made of a heading that directs gnuplot's output to a PNG of 960 x 540 pixels, and of `commands`. Throws Error
/// if gnuplot is not installed or fails, or the file cannot be written.
void draw_with_gnuplot(const std::filesystem::path& picture, const std::string& commands);

}  // namespace lippmann

// Draws the PSNR of every frame as a picture, with the program gnuplot.
#pragma once

#include <filesystem>

#include "compare/compare.hpp"

namespace lippmann {

/// Writes a PNG; identical frames, which have no PSNR, leave gaps. Throws Error if gnuplot is not installed or fails, or the
/// file cannot be written.
void plot_psnr(const Comparison& comparison, const std::filesystem::path& path);

}  // namespace lippmann

// Plots the PSNR of every frame with the program gnuplot.
#pragma once

#include <filesystem>

#include "compare/compare.hpp"

namespace lippmann {

/// Writes a PNG file. Identical frames have no PSNR and leave gaps. Throws Error if gnuplot is not installed or fails, or if
/// the file cannot be written.
void plot_psnr(const Comparison& comparison, const std::filesystem::path& path);

}  // namespace lippmann

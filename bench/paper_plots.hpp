// Draws plots of interpolated animations: the PSNR of each frame, and the savings.
#pragma once

#include <filesystem>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// Creates the folder. Writes psnr_<scene>.png for every scene, and saving.png. Throws Error if this fails.
void plot_reuse(const std::vector<ReuseRun>& runs, const std::filesystem::path& folder);

}  // namespace lippmann::bench

// Plots interpolated animations: PSNR per frame, and savings.
#pragma once

#include <filesystem>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// Creates the folder and writes psnr_<scene>.png for every scene, and saving.png. Throws Error.
void plot_reuse(const std::vector<ReuseRun>& runs, const std::filesystem::path& folder);

}  // namespace lippmann::bench

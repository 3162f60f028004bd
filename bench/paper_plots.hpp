#pragma once

#include <filesystem>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

void plot_reuse(const std::vector<ReuseRun>& runs, const std::filesystem::path& folder);

}  // namespace lippmann::bench

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lippmann::bench {

double cpu_seconds_of(const std::vector<std::string>& program, const std::filesystem::path& folder);

}  // namespace lippmann::bench

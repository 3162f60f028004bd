// Runs another program and measures its CPU time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lippmann::bench {

/// Runs a program in `folder`, discards its output, and returns its user and system CPU seconds. Finds `program` and passes its
/// arguments as a shell would. Throws Error if the program cannot be started or fails.
double cpu_seconds_of(const std::vector<std::string>& program, const std::filesystem::path& folder);

}  // namespace lippmann::bench

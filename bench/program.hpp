// Runs another program and says what CPU time it took.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lippmann::bench {

/// User and system CPU seconds of a program from start to end, its output thrown away. `program` and its arguments are looked
/// for and passed on as a shell would; it runs in `folder`. Throws Error where it cannot be started or fails.
double cpu_seconds_of(const std::vector<std::string>& program, const std::filesystem::path& folder);

}  // namespace lippmann::bench

// How many bytes of memory this process may still take.
#pragma once

#include <filesystem>

namespace lippmann {

/// The least of what Linux has available without swapping (MemAvailable), what the process's cgroups leave (versions 1 and 2,
/// files in the page cache not counted), and what limits of the address space and of data (ulimit -v, -d) leave beside the
/// threads' stacks. Infinite if nothing is known. proc, cgroups: where these file systems are mounted.
double available_memory_bytes(const std::filesystem::path& proc = "/proc",
                              const std::filesystem::path& cgroups = "/sys/fs/cgroup");

}  // namespace lippmann

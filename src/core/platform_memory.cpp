#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "core/platform.hpp"

namespace lippmann::platform {
namespace {

namespace fs = std::filesystem;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

std::optional<double> number_in(const fs::path& path) {
  std::ifstream file(path);
  double number = 0.0;
  return file >> number ? std::optional(number) : std::nullopt;
}

std::optional<double> number_after(const fs::path& path, const std::string& word) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    double number = 0.0;
    if (words >> first >> number && first == word) return number;
  }
  return std::nullopt;
}

struct CgroupFiles {
  const char *limit, *usage, *cache;
};
constexpr CgroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr CgroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};

double left_in(const fs::path& group, const CgroupFiles& files) {
  const std::optional<double> limit = number_in(group / files.limit), usage = number_in(group / files.usage);
  if (!limit || !usage) return kUnlimited;
  return *limit - *usage + number_after(group / "memory.stat", files.cache).value_or(0.0);
}

/// Returns the smallest number of bytes left in a cgroup and its parents. In some containers, `path` is a path of the host, and
/// only `root` exists.
double left_in_all(const fs::path& root, std::string path, const CgroupFiles& files) {
  double left = left_in(root, files);
  for (; path.size() > 1; path.resize(path.rfind('/'))) left = std::min(left, left_in(root / path.substr(1), files));
  return left;
}

/// Returns the smallest number of bytes left in the cgroups listed in proc/self/cgroup, whose lines are
/// NUMBER:CONTROLLERS:PATH. For cgroups version 2, CONTROLLERS is empty.
double left_in_cgroups(const fs::path& proc, const fs::path& root) {
  std::ifstream file(proc / "self/cgroup");
  double left = kUnlimited;
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = fmt::format(",{},", line.substr(first + 1, second - first - 1)),
                      path = line.substr(second + 1);
    if (!path.starts_with('/')) continue;
    if (controllers == ",,") left = std::min(left, left_in_all(root, path, kVersion2));
    if (controllers.find(",memory,") != std::string::npos) left = std::min(left, left_in_all(root / "memory", path, kVersion1));
  }
  return left;
}

constexpr double kThreadBytes = 64e6;

/// `column` is the column of /proc/self/statm that counts the used pages.
double left_of_limit(decltype(RLIMIT_AS) resource, const fs::path& proc, int column) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
  std::ifstream file(proc / "self/statm");
  double pages = 0.0;
  for (int i = 0; i <= column; ++i)
    if (!(file >> pages)) return kUnlimited;
  return static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGE_SIZE)) - kThreadBytes;
}

}  // namespace

double available_memory_bytes(const fs::path& proc, const fs::path& cgroups) {
  constexpr int kTotalColumn = 0, kDataColumn = 5;
  const std::optional<double> kilobytes = number_after(proc / "meminfo", "MemAvailable:");
  const double left = std::min({kilobytes ? 1024.0 * *kilobytes : kUnlimited, left_in_cgroups(proc, cgroups),
                                left_of_limit(RLIMIT_AS, proc, kTotalColumn), left_of_limit(RLIMIT_DATA, proc, kDataColumn)});
  return std::max(0.0, left);
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::optional<std::uint64_t> stack_limit_bytes() {
  rlimit stack{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur == RLIM_INFINITY) return std::nullopt;
  return stack.rlim_cur;
}

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kLeast = std::size_t{8} << 20;  // smallest size for which huge pages are requested: four pages of 2 MB
  if (bytes < kLeast) return;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)), begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t from = (begin + page - 1) / page * page, to = (begin + bytes) / page * page;
  madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);  // only a hint, so that failures do not matter
#endif
}

}  // namespace lippmann::platform

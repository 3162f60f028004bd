#include "core/platform.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

class AvailableMemory : public testing::Test {
 protected:
  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((dir_ / name).parent_path());
    std::ofstream(dir_ / name) << text;
  }
  double available() const { return platform::available_memory_bytes(dir_ / "proc", dir_ / "cgroup"); }

  TempDir dir_;
};

TEST_F(AvailableMemory, is_unlimited_by_default) { EXPECT_TRUE(std::isinf(available())); }

TEST_F(AvailableMemory, is_read_from_meminfo) {
  write("proc/meminfo", "MemTotal:       2000 kB\nMemFree:         100 kB\nMemAvailable:    1000 kB\n");
  EXPECT_EQ(available(), 1024'000.0);
}

TEST_F(AvailableMemory, is_limited_by_cgroups) {
  write("proc/meminfo", "MemAvailable:    1000 kB\n");
  write("proc/self/cgroup", "0::/slurm/job7\n");
  write("cgroup/slurm/job7/memory.max", "max\n");
  write("cgroup/slurm/job7/memory.current", "5000\n");
  EXPECT_EQ(available(), 1024'000.0) << "max means no limit";
  write("cgroup/slurm/memory.max", "10000\n");
  write("cgroup/slurm/memory.current", "7000\n");
  EXPECT_EQ(available(), 3000.0);
  write("cgroup/slurm/memory.stat", "anon 6000\ninactive_file 500\n");
  EXPECT_EQ(available(), 3500.0) << "cached files count as available";
  write("cgroup/slurm/memory.current", "20000\n");
  EXPECT_EQ(available(), 0.0);
}

TEST_F(AvailableMemory, is_limited_by_version_1_cgroups_and_containers) {
  write("proc/self/cgroup", "5:cpu,cpuacct:/docker/abc\n4:memory:/docker/abc\nbroken\n");
  // a container sees its own cgroup as the root cgroup
  write("cgroup/memory/memory.limit_in_bytes", "9000\n");
  write("cgroup/memory/memory.usage_in_bytes", "1000\n");
  EXPECT_EQ(available(), 8000.0);
}

TEST_F(AvailableMemory, is_limited_by_the_address_space) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  const rlimit limited{rlim_t{1} << 50, before.rlim_max};
  if (setrlimit(RLIMIT_AS, &limited) != 0) GTEST_SKIP() << "the limit cannot be set";
  write("proc/self/statm", "1000 500 100 10 0 300 0\n");
  const double page = static_cast<double>(sysconf(_SC_PAGE_SIZE));
  EXPECT_EQ(available(), std::ldexp(1.0, 50) - 1000.0 * page - 64e6);
  setrlimit(RLIMIT_AS, &before);
}

TEST(AvailableMemoryHere, is_positive) { EXPECT_GT(platform::available_memory_bytes(), 1e6); }

}  // namespace
}  // namespace lippmann::test

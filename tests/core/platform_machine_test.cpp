#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <thread>

#include "core/platform.hpp"

namespace lippmann::test {
namespace {

TEST(FlushDenormals, lasts_until_it_is_restored) {
#if !defined(__SSE2__) && !defined(__aarch64__)
  GTEST_SKIP() << "this processor cannot flush denormals";
#endif
  volatile float tiny = 1e-30f, denormal = 1e-39f;
  ASSERT_NE(tiny * 1e-10f, 0.0f);
  const unsigned before = platform::flush_denormals();
  const float result = tiny * 1e-10f, input = denormal * 1e10f;
  const unsigned again = platform::flush_denormals();
  platform::restore_float_control(before);
  EXPECT_EQ(result, 0.0f);
  EXPECT_EQ(input, 0.0f);
  EXPECT_NE(again, before);
  EXPECT_NE(tiny * 1e-10f, 0.0f);
}

TEST(Processors, usable_are_some_of_those_online) {
  EXPECT_GE(platform::usable_cpus(), 1);
  EXPECT_LE(platform::usable_cpus(), platform::online_cpus());
  EXPECT_NE(platform::cpu_model(), "");
}

TEST(Clocks, thread_clock_is_read_by_another_thread) {
  const platform::ThreadClock mine;
  double read = -1.0;
  std::thread([&] { read = mine.seconds(); }).join();
  EXPECT_GE(read, 0.0);
  EXPECT_LE(read, platform::thread_cpu_seconds());
  EXPECT_LE(platform::thread_cpu_seconds(), platform::process_cpu_seconds());
}

TEST(HostName, has_only_letters_digits_and_dashes) {
  const std::string name = platform::host_name();
  EXPECT_FALSE(name.empty());
  EXPECT_LE(name.size(), 64u);
  EXPECT_TRUE(std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '-'; })) << name;
}

TEST(RandomBits, differ) {
  bool differ = false;
  for (int i = 0; i < 4; ++i) differ |= platform::random_bits() != platform::random_bits();
  EXPECT_TRUE(differ);
}

TEST(Modules, own_code_lies_in_the_program) {
  EXPECT_EQ(platform::file_of_code(reinterpret_cast<const void*>(&platform::program_file)), platform::program_file());
  EXPECT_EQ(platform::program_file().filename(), "core_test");
}

TEST(Modules, library_that_cannot_be_loaded_is_named) {
  std::string problem;
  EXPECT_EQ(platform::load_library("/no/such/library.so", problem), nullptr);
  EXPECT_NE(problem.find("/no/such/library.so"), std::string::npos) << problem;
}

}  // namespace
}  // namespace lippmann::test

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "core/platform.hpp"
#include "support/file_bytes.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using platform::ChildProcess;

int exit_code_of(const platform::ChildCommand& command) {
  std::error_code problem;
  ChildProcess child(command, problem);
  EXPECT_FALSE(problem);
  return child.wait();
}

TEST(ChildProcess, exit_code_is_the_programs_or_its_signals) {
  EXPECT_EQ(exit_code_of({.words = {"true"}}), 0);
  EXPECT_EQ(exit_code_of({.words = {"sh", "-c", "exit 7"}}), 7);
  EXPECT_EQ(exit_code_of({.words = {"sh", "-c", "kill -TERM $$"}}), 128 + SIGTERM);
}

TEST(ChildProcess, missing_program_is_an_error) {
  std::error_code problem;
  ChildProcess child({.words = {"lippmann-no-such-program"}}, problem);
  EXPECT_EQ(problem, std::errc::no_such_file_or_directory);
  EXPECT_FALSE(child.is_running());
}

TEST(ChildProcess, silent_child_appends_messages) {
  const TempDir dir;
  std::ofstream(dir / "messages") << "before\n";
  EXPECT_EQ(exit_code_of({.words = {"sh", "-c", "cat; echo lost; pwd >&2"},
                          .folder = dir.path(),
                          .is_silent = true,
                          .messages = dir / "messages"}),
            0);
  EXPECT_EQ(file_bytes(dir / "messages"), "before\n" + fs::canonical(dir.path()).string() + "\n");
}

TEST(ChildProcess, interrupted_child_ends_by_that_signal) {
  std::error_code problem;
  ChildProcess child({.words = {"sleep", "1000"}}, problem);
  EXPECT_TRUE(child.is_running());
  child.interrupt();
  EXPECT_EQ(child.wait(), 128 + SIGINT);
  EXPECT_FALSE(child.is_running());
}

TEST(ChildProcess, child_obeys_signals_that_this_process_ignores) {
  const auto before = std::signal(SIGINT, SIG_IGN);
  std::error_code problem;
  ChildProcess child({.words = {"sleep", "1000"}}, problem);
  std::signal(SIGINT, before);
  child.interrupt();
  EXPECT_EQ(child.wait(), 128 + SIGINT);
}

TEST(ChildProcess, cpu_seconds_are_the_childs) {
  std::error_code problem;
  ChildProcess child({.words = {"sh", "-c", "i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done"}}, problem);
  EXPECT_EQ(child.wait(), 0);
  EXPECT_GT(child.cpu_seconds(), 0.0);
}

TEST(ProcessHandle, sees_which_files_a_process_writes) {
  const TempDir dir;
  std::ofstream(dir / "read") << "a";
  const std::ifstream read(dir / "read");
  const std::ofstream written(dir / "written");
  const platform::ProcessHandle self(platform::process_id());
  if (!self.is_there()) GTEST_SKIP() << "this system has no handles of processes";
  EXPECT_TRUE(self.is_visible());
  EXPECT_TRUE(self.writes(dir / "written"));
  EXPECT_FALSE(self.writes(dir / "read"));
  EXPECT_FALSE(self.writes(dir / "none"));
}

TEST(ProcessHandle, no_process_has_number_zero) { EXPECT_FALSE(platform::ProcessHandle(0).is_there()); }

}  // namespace
}  // namespace lippmann::test

// Runs a program as from a shell, and keeps its stdout and stderr separately.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace lippmann::test {

struct RunResult {
  int exit_code = -1;  ///< 128 + n if signal n ended it; 127 if it could not be started
  std::string out, err;
};

struct RunOptions {
  std::string working_folder;       ///< empty: this process's
  std::size_t file_size_limit = 0;  ///< in bytes; writing more fails as on a full disk; 0: no limit
};

/// A program that runs beside the test; killed on destruction unless it was waited for. stdin is empty.
class Subprocess {
 public:
  explicit Subprocess(const std::vector<std::string>& command, const RunOptions& options = {});
  ~Subprocess();
  Subprocess(const Subprocess&) = delete;
  Subprocess& operator=(const Subprocess&) = delete;

  void signal(int number) const;
  /// Waits until it has printed a whole line on stdout, or has closed stdout.
  void wait_for_line();
  RunResult wait();

 private:
  pid_t pid_ = -1;
  RunResult printed_;  ///< output so far
  int out_ = -1, err_ = -1;
};

/// Runs a program to its end.
RunResult run(const std::vector<std::string>& command, const RunOptions& options = {});

}  // namespace lippmann::test

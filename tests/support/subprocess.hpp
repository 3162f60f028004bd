// Runs a program as a shell does. Its stdout and stderr are kept separately.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace lippmann::test {

struct RunResult {
  int exit_code = -1;  ///< 128 + n if signal n ended the program; 127 if the program could not be started
  std::string out, err;
};

struct RunOptions {
  std::string working_folder;       ///< if empty, the folder of this process
  std::size_t file_size_limit = 0;  ///< in bytes; writing more fails as on a full disk; 0 means no limit
};

/// A program that runs at the same time as the test. Its stdin is empty. The destructor kills the program if wait() was not
/// called.
class Subprocess {
 public:
  explicit Subprocess(const std::vector<std::string>& command, const RunOptions& options = {});
  ~Subprocess();
  Subprocess(const Subprocess&) = delete;
  Subprocess& operator=(const Subprocess&) = delete;

  void signal(int number) const;
  /// Waits until the program has printed a line on stdout or has closed stdout.
  void wait_for_line();
  RunResult wait();

 private:
  pid_t pid_ = -1;
  RunResult printed_;  ///< output that has been read
  int out_ = -1, err_ = -1;
};

/// Runs a program and waits for its end.
RunResult run(const std::vector<std::string>& command, const RunOptions& options = {});

}  // namespace lippmann::test

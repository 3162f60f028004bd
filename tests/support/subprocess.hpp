// Runs a program, and keeps its stdout and stderr separately.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace lippmann::test {

struct RunResult {
  int exit_code = -1;  ///< 128 + n if signal n ended the program; 127 if it could not be started
  std::string out, err;
};

struct RunOptions {
  std::string working_folder;       ///< empty: the folder of this process
  std::size_t file_size_limit = 0;  ///< in bytes; writing more fails as on a full disk; 0: no limit
};

/// Runs a program beside the test, with an empty stdin. The destructor kills it unless wait() was called.
class Subprocess {
 public:
  explicit Subprocess(const std::vector<std::string>& command, const RunOptions& options = {});
  ~Subprocess();
  Subprocess(const Subprocess&) = delete;
  Subprocess& operator=(const Subprocess&) = delete;

  void signal(int number) const;
  void wait_for_line();
  RunResult wait();

 private:
  pid_t pid_ = -1;
  RunResult printed_;
  int out_ = -1, err_ = -1;
};

RunResult run(const std::vector<std::string>& command, const RunOptions& options = {});

}  // namespace lippmann::test

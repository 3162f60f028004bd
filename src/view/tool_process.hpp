// Runs the command-line tool as a child process. Discards its standard output and keeps its messages (stderr).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/platform.hpp"

namespace lippmann {

struct ToolCommand {
  std::filesystem::path program;
  std::vector<std::string> words;
};

/// Not thread-safe.
class ToolProcess {
 public:
  explicit ToolProcess(const ToolCommand& command);
  ~ToolProcess();
  ToolProcess(const ToolProcess&) = delete;
  ToolProcess& operator=(const ToolProcess&) = delete;

  bool is_running();

  /// Interrupts the process as Ctrl-C does. Further calls have no effect.
  void interrupt();

  /// Returns the end of stderr if the process failed. Returns an empty string while the process runs, after success, and after
  /// interrupt().
  std::string failure();

 private:
  void end(int exit_code);

  std::unique_ptr<platform::ChildProcess> process_;
  bool is_interrupted_ = false;
  std::filesystem::path messages_;
  std::string failure_;
};

}  // namespace lippmann

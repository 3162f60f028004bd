// Runs the command-line tool as a child process. Its standard output is discarded; its messages (stderr) are kept.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/platform.hpp"

namespace lippmann {

struct ToolCommand {
  std::filesystem::path program;   ///< path of the command-line tool
  std::vector<std::string> words;  ///< arguments of the tool
};

/// Not thread-safe.
class ToolProcess {
 public:
  /// Starts the process. Throws Error if that fails.
  explicit ToolProcess(const ToolCommand& command);
  /// Interrupts the process and waits until it has ended.
  ~ToolProcess();
  ToolProcess(const ToolProcess&) = delete;
  ToolProcess& operator=(const ToolProcess&) = delete;

  bool is_running();

  /// Interrupts the process like Ctrl-C. Further calls have no effect.
  void interrupt();

  /// Returns the end of the process's stderr if it failed. Empty while it runs, after success, and after interrupt().
  std::string failure();

 private:
  void end(int exit_code);

  std::unique_ptr<platform::ChildProcess> process_;  ///< null after the process has ended
  bool is_interrupted_ = false;
  std::filesystem::path messages_;  ///< the file that receives stderr
  std::string failure_;
};

}  // namespace lippmann

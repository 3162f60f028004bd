// Another process of the tool itself, with its messages; what it prints is dropped.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/platform.hpp"

namespace lippmann {

struct ToolCommand {
  std::filesystem::path program;   ///< the tool
  std::vector<std::string> words;  ///< what it is called with
};

/// Not thread-safe.
class ToolProcess {
 public:
  /// Throws Error if it cannot be started.
  explicit ToolProcess(const ToolCommand& command);
  /// Does what Ctrl-C does, and waits until it has ended.
  ~ToolProcess();
  ToolProcess(const ToolProcess&) = delete;
  ToolProcess& operator=(const ToolProcess&) = delete;

  /// Looks whether it has ended.
  bool is_running();

  /// Does what Ctrl-C does, once.
  void interrupt();

  /// Empty while it runs and where it has done its work or was interrupted; else the end of what it said on stderr.
  std::string failure();

 private:
  void end(int exit_code);

  std::unique_ptr<platform::ChildProcess> process_;  ///< null: it has ended
  bool is_interrupted_ = false;
  std::filesystem::path messages_;  ///< the file that stderr goes to
  std::string failure_;
};

}  // namespace lippmann

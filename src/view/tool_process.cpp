#include "view/tool_process.hpp"

#include <fmt/core.h>

#include <system_error>

#include "core/platform.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// A file receives the child's messages. A pipe would have to be read continuously.
fs::path file_for_messages() {
  std::error_code problem;
  fs::path file = platform::make_unique_file(fs::temp_directory_path() / "lippmann-messages-", problem);
  if (problem) throw Error(file.string(), "cannot be made");
  return file;
}

void remove_messages(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

std::string end_of(const fs::path& file) {
  constexpr std::size_t kMax = 2000;
  constexpr std::size_t kMaxRead = std::size_t{1} << 24;
  std::string text = read_file_begin(file, kMaxRead);
  while (text.ends_with('\n')) text.pop_back();
  return text.size() > kMax ? text.substr(text.size() - kMax) : text;
}

}  // namespace

ToolProcess::ToolProcess(const ToolCommand& command) : messages_(file_for_messages()) {
  platform::ChildCommand child{.words = {command.program.string()}, .is_silent = true, .messages = messages_};
  child.words.insert(child.words.end(), command.words.begin(), command.words.end());
  std::error_code problem;
  process_ = std::make_unique<platform::ChildProcess>(child, problem);
  if (!problem) return;
  remove_messages(messages_);
  throw Error(command.program.string(), fmt::format("cannot be started ({})", problem.message()));
}

ToolProcess::~ToolProcess() {
  interrupt();
  process_.reset();
  remove_messages(messages_);
}

bool ToolProcess::is_running() {
  if (process_ && !process_->is_running()) end(process_->wait());
  return process_ != nullptr;
}

void ToolProcess::interrupt() {
  if (is_interrupted_ || !is_running()) return;
  is_interrupted_ = true;
  process_->interrupt();
}

std::string ToolProcess::failure() { return is_running() ? std::string() : failure_; }

void ToolProcess::end(int exit_code) {
  process_.reset();
  if (is_interrupted_ || exit_code == 0) return;
  failure_ = end_of(messages_);
  if (failure_.empty()) failure_ = "The render failed without a message.";
}

}  // namespace lippmann

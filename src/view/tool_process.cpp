#include "view/tool_process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <system_error>

#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

extern char** environ;

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Where its messages go, without a name that anybody else could have put there.
fs::path file_for_messages() {
  std::string name = (fs::temp_directory_path() / "lippmann-messages-XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw Error(name, "cannot be made");
  close(descriptor);
  return name;
}

/// A pipe would have to be read all the time, a file has not.
struct Redirections {
  posix_spawn_file_actions_t actions{};
  explicit Redirections(const fs::path& messages) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), O_WRONLY | O_APPEND, 0);
  }
  ~Redirections() { posix_spawn_file_actions_destroy(&actions); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;
};

std::string end_of(const fs::path& file) {
  constexpr std::size_t kMost = 2000;
  constexpr std::size_t kMostRead = std::size_t{1} << 24;
  std::string text = read_file_begin(file, kMostRead);
  while (text.ends_with('\n')) text.pop_back();
  return text.size() > kMost ? text.substr(text.size() - kMost) : text;
}

}  // namespace

ToolProcess::ToolProcess(const ToolCommand& command) : messages_(file_for_messages()) {
  const fs::path& program = command.program;
  std::vector<std::string> all{program.string()};
  all.insert(all.end(), command.words.begin(), command.words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const Redirections redirections(messages_);
  const int problem = posix_spawn(&process_, program.c_str(), &redirections.actions, nullptr, arguments.data(), environ);
  if (problem == 0) return;
  std::error_code ignored;
  fs::remove(messages_, ignored);
  throw Error(program.string(), fmt::format("cannot be started ({})", std::generic_category().message(problem)));
}

ToolProcess::~ToolProcess() {
  interrupt();
  int status = 0;
  if (process_ != 0) waitpid(process_, &status, 0);
  std::error_code ignored;
  fs::remove(messages_, ignored);
}

bool ToolProcess::is_running() {
  int status = 0;
  if (process_ != 0 && waitpid(process_, &status, WNOHANG) == process_) end(status);
  return process_ != 0;
}

void ToolProcess::interrupt() {
  if (is_interrupted_ || !is_running()) return;
  is_interrupted_ = true;
  kill(process_, SIGINT);  // its number stays its own until it is waited for
}

std::string ToolProcess::failure() { return is_running() ? std::string() : failure_; }

void ToolProcess::end(int status) {
  process_ = 0;
  if (is_interrupted_ || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) return;
  failure_ = end_of(messages_);
  if (failure_.empty()) failure_ = "The render ended without a word.";
}

}  // namespace lippmann

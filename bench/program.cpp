#include "bench/program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "lippmann/core/error.hpp"

namespace lippmann::bench {
namespace {

/// In the child: becomes the program, or ends with 127.
[[noreturn]] void become(const std::vector<char*>& arguments, const std::filesystem::path& folder) {
  const int nothing = open("/dev/null", O_RDWR);
  if (nothing < 0 || chdir(folder.c_str()) != 0) _exit(127);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

double to_seconds(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

}  // namespace

double cpu_seconds_of(const std::vector<std::string>& program, const std::filesystem::path& folder) {
  std::vector<char*> arguments;
  for (const std::string& word : program) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw Error(program[0], "no process can be started");
  if (child == 0) become(arguments, folder);
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) == 127)
    throw Error(program[0], "the program is not installed or was ended", "Debian has it in the package tachyon-bin-nox");
  if (WEXITSTATUS(status) != 0) throw Error(program[0], "it failed with exit code " + std::to_string(WEXITSTATUS(status)));
  return to_seconds(usage.ru_utime) + to_seconds(usage.ru_stime);
}

}  // namespace lippmann::bench

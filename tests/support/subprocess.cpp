#include "support/subprocess.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

namespace lippmann::test {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe2");
  return ends;
}

[[noreturn]] void become(const std::vector<char*>& arguments, const RunOptions& options, int out, int err) {
  if (options.file_size_limit > 0) {
    const rlimit limit{options.file_size_limit, options.file_size_limit};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (!options.working_folder.empty() && chdir(options.working_folder.c_str()) != 0) _exit(127);
  dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

enum class Until { kLine, kEnd };

/// Reads stdout and stderr until stdout contains a line (kLine), or until both are closed (kEnd).
void drain(int out, int err, Until until, RunResult& result) {
  std::array<pollfd, 2> ends{pollfd{out, POLLIN, 0}, pollfd{err, POLLIN, 0}};
  const std::array<std::string*, 2> texts{&result.out, &result.err};
  for (int open_ends = 2; open_ends > 0;) {
    if (until == Until::kLine && (ends[0].fd < 0 || result.out.find('\n') != std::string::npos)) return;
    if (poll(ends.data(), ends.size(), -1) < 0) {
      if (errno == EINTR) continue;
      fail("poll");
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].fd < 0 || ends[i].revents == 0) continue;
      std::array<char, 4096> buffer{};
      const ssize_t count = read(ends[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      } else {
        ends[i].fd = -1;
        --open_ends;
      }
    }
  }
}

}  // namespace

Subprocess::Subprocess(const std::vector<std::string>& command, const RunOptions& options) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const auto out = make_pipe(), err = make_pipe();
  pid_ = fork();
  if (pid_ < 0) fail("fork");
  if (pid_ == 0) become(arguments, options, out[1], err[1]);
  close(out[1]);
  close(err[1]);
  out_ = out[0];
  err_ = err[0];
}

Subprocess::~Subprocess() {
  if (pid_ < 0) return;
  signal(SIGKILL);
  wait();
}

void Subprocess::signal(int number) const { kill(pid_, number); }

void Subprocess::wait_for_line() { drain(out_, err_, Until::kLine, printed_); }

RunResult Subprocess::wait() {
  drain(out_, err_, Until::kEnd, printed_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  close(out_);
  close(err_);
  printed_.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return std::move(printed_);
}

RunResult run(const std::vector<std::string>& command, const RunOptions& options) {
  return Subprocess(command, options).wait();
}

}  // namespace lippmann::test

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "core/platform.hpp"
#include "core/printable.hpp"

extern char** environ;

namespace lippmann::platform {
namespace {

namespace fs = std::filesystem;

// Uses raw system calls, since glibc has wrappers only since 2.36.
int open_process([[maybe_unused]] int process) {
#ifdef SYS_pidfd_open
  return process > 0 ? static_cast<int>(syscall(SYS_pidfd_open, process, 0)) : -1;
#else
  return -1;
#endif
}

bool send_signal([[maybe_unused]] int descriptor, [[maybe_unused]] int signal) {
#ifdef SYS_pidfd_send_signal
  return syscall(SYS_pidfd_send_signal, descriptor, signal, nullptr, 0) == 0;
#else
  return false;
#endif
}

std::string open_files_of(int process) { return fmt::format("/proc/{}/fd", process); }

/// Returns whether `link`, an entry of /proc/PID/fd, refers to `file` and is open for writing. Linux sets the write permission
/// of links to files that are open for writing.
bool is_open_for_writing(const fs::path& link, const struct stat& file) {
  struct stat opened {
  }, itself{};
  return stat(link.c_str(), &opened) == 0 && lstat(link.c_str(), &itself) == 0 && opened.st_dev == file.st_dev &&
         opened.st_ino == file.st_ino && (itself.st_mode & S_IWUSR) != 0;
}

class ChildActions {
 public:
  explicit ChildActions(const ChildCommand& command) {
    posix_spawn_file_actions_init(&actions_);
    if (!command.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, command.folder.c_str());
    if (!command.is_silent) return;
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const char* messages = command.messages.empty() ? "/dev/null" : command.messages.c_str();
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, messages, O_WRONLY | O_APPEND, 0);
  }
  ~ChildActions() { posix_spawn_file_actions_destroy(&actions_); }
  ChildActions(const ChildActions&) = delete;
  ChildActions& operator=(const ChildActions&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Restores the default action of signals that this process may ignore: SIGINT in background jobs of shells, and SIGPIPE and
/// SIGXFSZ after ignore_write_signals().
class ChildAttributes {
 public:
  ChildAttributes() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGPIPE, SIGXFSZ}) sigaddset(&signals, signal);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  ~ChildAttributes() { posix_spawnattr_destroy(&attributes_); }
  ChildAttributes(const ChildAttributes&) = delete;
  ChildAttributes& operator=(const ChildAttributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

double to_seconds(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

}  // namespace

int process_id() { return getpid(); }

bool is_process_gone(int process) { return kill(process, 0) != 0 && errno == ESRCH; }

ProcessHandle::ProcessHandle(int process) : process_(process), descriptor_(open_process(process)) {}

ProcessHandle::~ProcessHandle() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool ProcessHandle::is_visible() const { return access(open_files_of(process_).c_str(), R_OK) == 0; }

bool ProcessHandle::writes(const fs::path& path) const {
  struct stat file {};
  if (stat(path.c_str(), &file) != 0) return false;
  std::error_code problem;
  fs::directory_iterator links(open_files_of(process_), problem);
  for (; !problem && links != fs::directory_iterator(); links.increment(problem))
    if (is_open_for_writing(links->path(), file)) return true;
  return false;
}

bool ProcessHandle::interrupt() const { return send_signal(descriptor_, SIGINT); }

ChildProcess::ChildProcess(const ChildCommand& command, std::error_code& problem) {
  std::vector<std::string> words = command.words;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const ChildActions actions(command);
  const ChildAttributes attributes;
  const int error = posix_spawnp(&process_, arguments[0], actions.get(), attributes.get(), arguments.data(), environ);
  if (error != 0) process_ = 0;
  problem = std::error_code(error, std::generic_category());
}

ChildProcess::~ChildProcess() { wait(); }

bool ChildProcess::has_ended(int options) {
  if (process_ == 0) return true;
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  do ended = wait4(process_, &status, options, &usage);
  while (ended < 0 && errno == EINTR);
  if (ended == 0) return false;
  process_ = 0;
  if (ended > 0) {
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    cpu_seconds_ = to_seconds(usage.ru_utime) + to_seconds(usage.ru_stime);
  }
  return true;
}

bool ChildProcess::is_running() { return !has_ended(WNOHANG); }

void ChildProcess::interrupt() {
  if (process_ != 0) kill(process_, SIGINT);  // safe: the id is not reused before wait4()
}

int ChildProcess::wait() {
  has_ended(0);
  return exit_code_;
}

bool open_in_browser(const std::string& address) {
  const std::string command = "xdg-open " + shell_word(address) + " >/dev/null 2>&1 &";
  return std::system(command.c_str()) == 0;
}

bool is_stderr_terminal() { return isatty(STDERR_FILENO) == 1; }

void open_missing_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF && open("/dev/null", O_RDWR) != stream) return;
}

void ignore_write_signals() {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
}

}  // namespace lippmann::platform

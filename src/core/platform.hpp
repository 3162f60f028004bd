#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace lippmann::platform {

/// Returns how many bytes of memory this process may still allocate, or infinity if unknown: the minimum of
/// - the memory available without swapping (MemAvailable of Linux),
/// - the remaining limit of each cgroup of the process (versions 1 and 2), where inactive page cache counts as available,
/// - the remaining limits of address space and data (ulimit -v, -d), less 64 MB for threads.
/// `proc` and `cgroups` are the mount points of these file systems.
double available_memory_bytes(const std::filesystem::path& proc = "/proc",
                              const std::filesystem::path& cgroups = "/sys/fs/cgroup");

std::uint64_t peak_memory_bytes();

/// Returns the largest stack size in bytes of the main thread and of threads started later, or nothing if it is unlimited or
/// unknown.
std::optional<std::uint64_t> stack_limit_bytes();

/// Requests huge pages for memory that is reserved and not yet written, to reduce TLB misses. Has no effect if unsupported, or
/// for less than 8 MB.
void prefer_huge_pages(void* memory, std::size_t bytes);

template <class T>
void reserve_huge(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  prefer_huge_pages(values.data(), count * sizeof(T));
}

std::string cpu_model();

/// Returns the number of processors that this process may run on (its affinity mask).
int usable_cpus();
/// Returns the number of online processors of the machine.
int online_cpus();

/// Flushes denormal inputs and results to zero in this thread (x86 and ARM64). Returns the previous control register for
/// restore_float_control().
unsigned flush_denormals();
void restore_float_control(unsigned control);

/// Return the CPU seconds of this process (all threads) or of the calling thread since its start.
double process_cpu_seconds();
double thread_cpu_seconds();

/// The CPU clock of the thread that constructs this object. Other threads may call seconds() while that thread exists.
class ThreadClock {
 public:
  ThreadClock();
  double seconds() const;

 private:
  std::int64_t clock_;
};

std::string machine_name();
/// Returns the first 64 letters, digits and dashes of the host name, or "host" if it contains none.
std::string host_name();
std::string system_name();

/// Returns 32 random bits from the system, or 0 if it has no source of random bits.
std::uint32_t random_bits();

/// An open file, or no file. Not thread-safe, except for renew().
class OpenFile {
 public:
  enum class Mode {
    kRead,    ///< an existing file; opening a FIFO does not wait for its writer
    kCreate,  ///< a new file for reading and writing; fails if the name exists
    kAppend,
  };

  OpenFile() = default;
  OpenFile(const std::filesystem::path& path, Mode mode, std::error_code& problem);
  ~OpenFile() { static_cast<void>(close()); }
  OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept;

  bool is_open() const { return descriptor_ >= 0; }

  std::filesystem::file_type kind(std::uintmax_t& bytes, std::error_code& problem) const;

  /// Reads `count` bytes, or fewer at the end of the file and after a failure. Returns the number of bytes read.
  std::size_t read(void* to, std::size_t count, std::error_code& problem);
  std::error_code write(const void* from, std::size_t count);
  std::int64_t seek(std::int64_t offset, int whence);
  /// Waits until all bytes are on the disk. Ignores file systems without this operation.
  std::error_code sync();
  /// Closes the file. Errors of delayed writes may be reported only here.
  std::error_code close();

  /// Returns whether the path still refers to this file.
  bool is_at(const std::filesystem::path& path) const;
  /// Sets the modification time of the file to now. May run concurrently with other calls.
  void renew() const;

 private:
  int descriptor_ = -1;
};

/// sync_file() waits until the bytes of a file are on the disk. sync_folder() waits until the names of a folder's files are on
/// the disk; an empty path means the working folder. On failure, these functions throw Error that names the path. They have no
/// effect on file systems without this operation and on unreadable files or folders.
void sync_file(const std::filesystem::path& file);
void sync_folder(const std::filesystem::path& folder);

std::error_code check_writable(const std::filesystem::path& folder);

void remove_file(const std::filesystem::path& file);

/// Creates a new empty file or folder named `prefix` plus random letters, readable only by this user.
std::filesystem::path make_unique_file(const std::filesystem::path& prefix, std::error_code& problem);
std::filesystem::path make_unique_folder(const std::filesystem::path& prefix, std::error_code& problem);

int process_id();
bool is_process_gone(int process);

/// Another process of this machine. The handle refers to the same process even if its id is reused. On systems without such
/// handles, is_there() and interrupt() return false.
class ProcessHandle {
 public:
  explicit ProcessHandle(int process);
  ~ProcessHandle();
  ProcessHandle(const ProcessHandle&) = delete;
  ProcessHandle& operator=(const ProcessHandle&) = delete;

  bool is_there() const { return descriptor_ >= 0; }
  bool is_visible() const;
  bool writes(const std::filesystem::path& file) const;
  bool interrupt() const;

 private:
  int process_, descriptor_;
};

struct ChildCommand {
  std::vector<std::string> words;  ///< name or path of the program, then its arguments; a name is searched in PATH
  std::filesystem::path folder = {};
  bool is_silent = false;
  std::filesystem::path messages = {};
};

class ChildProcess {
 public:
  ChildProcess(const ChildCommand& command, std::error_code& problem);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool is_running();
  void interrupt();
  /// Returns the exit code, or 128 plus the number of the signal that ended the process.
  int wait();
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  bool has_ended(int options);

  int process_ = 0;
  int exit_code_ = 0;
  double cpu_seconds_ = 0.0;
};

bool open_in_browser(const std::string& address);

bool is_stderr_terminal();

/// Opens /dev/null for each standard stream that was closed when the process started, so that the next file that the program
/// opens does not become that stream.
void open_missing_streams();

/// Makes writes to a closed pipe, or beyond the file size limit, fail with an error instead of a signal that ends the process.
void ignore_write_signals();

std::filesystem::path program_file();
std::filesystem::path file_of_code(const void* address);

void* load_library(const std::filesystem::path& file, std::string& problem);
void* find_symbol(void* library, const char* name);

/// Sending and receiving do not block. Not thread-safe.
class Socket {
 public:
  struct Transfer {
    std::size_t bytes = 0;
    /// Whether the peer has closed the connection or the connection failed. If false and `bytes` is 0, try again later.
    bool is_over = false;
  };

  Socket() = default;
  explicit Socket(std::intptr_t handle) : handle_(handle) {}
  ~Socket() { close(); }
  Socket(Socket&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  Socket& operator=(Socket&& other) noexcept;

  /// Listens at the first usable address of the host. Port 0 selects any free port. Returns a closed socket on failure.
  static Socket listen(const std::string& host, int port);

  bool is_open() const { return handle_ >= 0; }
  std::intptr_t handle() const { return handle_; }
  int port() const;

  /// Returns a closed socket if no connection is pending. Sets `is_full` to whether this process or the system has too many
  /// open files.
  Socket accept(bool& is_full) const;
  Transfer receive(std::span<char> to);
  /// If `more_follows`, the system may delay the last packet to combine it with the next data.
  Transfer send(std::string_view bytes, bool more_follows);
  /// Signals to the peer that no more data follows.
  void end_sending();

 private:
  void close();

  std::intptr_t handle_ = -1;
};

/// Lets one thread wake another thread that is in wait_for_any().
class WakeSignal {
 public:
  WakeSignal();
  ~WakeSignal();
  WakeSignal(const WakeSignal&) = delete;
  WakeSignal& operator=(const WakeSignal&) = delete;

  std::intptr_t handle() const { return handle_; }
  void raise();
  void clear();

 private:
  std::intptr_t handle_;
};

enum class SocketEvent { kNone, kReadable, kWritable };

struct WatchedSocket {
  std::intptr_t handle;
  SocketEvent event;
  bool is_ready = false;  ///< whether the event has happened or the socket failed
};

/// Waits until at least one of the events happens, for at most `timeout`. Returns whether an event happened.
bool wait_for_any(std::span<WatchedSocket> sockets, std::chrono::milliseconds timeout);

}  // namespace lippmann::platform

// The interface to the operating system: memory, processors, files, processes, modules and sockets.
//
// Only core/platform_*.cpp include system headers, one file per section below (scripts/check_layers checks this). A port to
// another system replaces only these files.
//
// Unless stated otherwise, functions are thread-safe and report failures as a std::error_code of the generic category. The
// comment of a function states what it does on systems that lack the feature.
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

// ---- Memory (platform_memory.cpp) ---------------------------------------------------------------------------------------

/// Returns how many bytes of memory this process may still allocate, or infinity if unknown. The result is the minimum of:
/// - the memory available without swapping (MemAvailable of Linux),
/// - the remaining limit of each cgroup of the process (versions 1 and 2), where inactive page cache counts as available,
/// - the remaining limits of address space and data (ulimit -v, -d), less 64 MB for threads.
/// `proc` and `cgroups` are the mount points of these file systems.
double available_memory_bytes(const std::filesystem::path& proc = "/proc",
                              const std::filesystem::path& cgroups = "/sys/fs/cgroup");

/// Returns the peak memory of this process, or 0 if unknown.
std::uint64_t peak_memory_bytes();

/// Returns the largest stack size in bytes of the main thread and of threads started later, or nothing if it is unlimited or
/// unknown.
std::optional<std::uint64_t> stack_limit_bytes();

/// Requests huge pages for memory that is reserved and not yet written, to reduce TLB misses. Has no effect if unsupported, or
/// for less than 8 MB.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// Reserves room for `count` values, in huge pages if possible.
template <class T>
void reserve_huge(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  prefer_huge_pages(values.data(), count * sizeof(T));
}

// ---- Processors, clocks, the machine (platform_machine.cpp) ---------------------------------------------------------------

/// Returns the processor's name for timing reports, or "unknown".
std::string cpu_model();

/// Returns the number of processors that this process may run on (its affinity mask); at least 1.
int usable_cpus();
/// Returns the number of online processors of the machine; at least 1.
int online_cpus();

/// Flushes denormal inputs and results to zero in this thread (MXCSR on x86, FPCR on ARM64; no effect elsewhere). Returns the
/// previous control register for restore_float_control().
unsigned flush_denormals();
void restore_float_control(unsigned control);

/// Return the CPU seconds of this process (all threads) or of the calling thread since its start.
double process_cpu_seconds();
double thread_cpu_seconds();

/// The CPU clock of the thread that constructs this object. Other threads may call seconds() while the constructing thread
/// exists.
class ThreadClock {
 public:
  ThreadClock();
  double seconds() const;

 private:
  std::int64_t clock_;
};

/// Returns the machine's host name, or an empty string.
std::string machine_name();
/// Returns the first 64 letters, digits and dashes of the host name, or "host" if it contains none. The result is used in the
/// names of files that several machines write into one folder.
std::string host_name();
/// Returns the system's name and version, such as "Linux 6.1.0".
std::string system_name();

/// Returns 32 random bits from the system, or 0 if the system has no source of random bits.
std::uint32_t random_bits();

// ---- Files (platform_files.cpp) -------------------------------------------------------------------------------------------

/// An open file, or no file. Not thread-safe, except for renew().
class OpenFile {
 public:
  enum class Mode {
    kRead,    ///< an existing file; opening a FIFO does not wait for its writer
    kCreate,  ///< a new file for reading and writing; fails if the name exists
    kAppend,  ///< a new file that every write appends to; fails if the name exists
  };

  OpenFile() = default;
  OpenFile(const std::filesystem::path& path, Mode mode, std::error_code& problem);
  ~OpenFile() { static_cast<void>(close()); }
  OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept;

  bool is_open() const { return descriptor_ >= 0; }

  /// Returns the type of the file. `bytes` receives its size.
  std::filesystem::file_type kind(std::uintmax_t& bytes, std::error_code& problem) const;

  /// Reads `count` bytes, or fewer at the end of the file and after a failure. Returns the number of bytes read.
  std::size_t read(void* to, std::size_t count, std::error_code& problem);
  std::error_code write(const void* from, std::size_t count);
  /// Moves to `offset` from the beginning (SEEK_SET), the current position (SEEK_CUR) or the end (SEEK_END). Returns the new
  /// position, or -1 on failure.
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
/// the disk; an empty path means the working folder. Synced data survives a loss of power. Throw Error that names the path on
/// failure. Have no effect on file systems without this operation and on unreadable files or folders.
void sync_file(const std::filesystem::path& file);
void sync_folder(const std::filesystem::path& folder);

/// Returns the reason why no file can be created in an existing folder, or no error if files can be created.
std::error_code check_writable(const std::filesystem::path& folder);

/// Removes a file, but never a folder. Ignores failures.
void remove_file(const std::filesystem::path& file);

/// Creates a new empty file or folder named `prefix` plus random letters, readable only by this user.
std::filesystem::path make_unique_file(const std::filesystem::path& prefix, std::error_code& problem);
std::filesystem::path make_unique_folder(const std::filesystem::path& prefix, std::error_code& problem);

// ---- Processes (platform_process.cpp) -------------------------------------------------------------------------------------

int process_id();
/// Returns whether no process has the id.
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
  /// Returns whether this process may list the open files of the other process.
  bool is_visible() const;
  /// Returns whether the process has the file open for writing. Returns false if is_visible() is false.
  bool writes(const std::filesystem::path& file) const;
  /// Sends SIGINT, like Ctrl-C. Returns whether the signal was sent.
  bool interrupt() const;

 private:
  int process_, descriptor_;
};

struct ChildCommand {
  std::vector<std::string> words;       ///< name or path of the program, then its arguments; a name is searched in PATH
  std::filesystem::path folder = {};    ///< working folder of the child; empty: the working folder of this process
  bool is_silent = false;               ///< whether the child's input is empty and its output is discarded
  std::filesystem::path messages = {};  ///< existing file to which a silent child's standard error is appended
};

/// A child process. Not thread-safe.
class ChildProcess {
 public:
  ChildProcess(const ChildCommand& command, std::error_code& problem);
  /// Waits for the end of the process.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool is_running();
  /// Sends SIGINT, like Ctrl-C.
  void interrupt();
  /// Waits for the end of the process. Returns its exit code, or 128 plus the number of the signal that ended it.
  int wait();
  /// Returns the CPU seconds of the finished process.
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  bool has_ended(int options);

  int process_ = 0;  ///< 0: finished, or never started
  int exit_code_ = 0;
  double cpu_seconds_ = 0.0;
};

/// Opens an address in the user's browser, without waiting for the browser to end. Returns whether a shell could be started.
bool open_in_browser(const std::string& address);

bool is_stderr_terminal();

/// Opens /dev/null for each standard stream that was closed when the process started. Otherwise the next file that the program
/// opens would become that stream.
void open_missing_streams();

/// Makes writes to a closed pipe, or beyond the file size limit, fail with an error. By default they send signals that end the
/// process.
void ignore_write_signals();

// ---- Modules (platform_modules.cpp) ---------------------------------------------------------------------------------------

/// Returns the path of the running program's file, or an empty path.
std::filesystem::path program_file();
/// Returns the path of the program or shared library that contains the code at an address, or an empty path.
std::filesystem::path file_of_code(const void* address);

/// Loads a shared library, with its symbols hidden, until the process ends. Returns null on failure, and a message in
/// `problem`.
void* load_library(const std::filesystem::path& file, std::string& problem);
/// Returns the address of a symbol of a loaded library, or null.
void* find_symbol(void* library, const char* name);

// ---- Sockets (platform_sockets.cpp) ---------------------------------------------------------------------------------------

/// A TCP socket, open or closed. Sending and receiving do not block. Not thread-safe.
class Socket {
 public:
  struct Transfer {
    std::size_t bytes = 0;
    /// Whether the peer has closed the connection or the connection failed. If false and `bytes` is 0, try again later.
    bool is_over = false;
  };

  Socket() = default;
  /// Takes ownership of a non-blocking system socket.
  explicit Socket(std::intptr_t handle) : handle_(handle) {}
  ~Socket() { close(); }
  Socket(Socket&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  Socket& operator=(Socket&& other) noexcept;

  /// Listens at the first usable address of the host. Port 0 selects any free port. Returns a closed socket on failure.
  static Socket listen(const std::string& host, int port);

  bool is_open() const { return handle_ >= 0; }
  std::intptr_t handle() const { return handle_; }
  /// Returns the local port, or 0.
  int port() const;

  /// Accepts a connection on a listening socket. Returns a closed socket if no connection is pending. Sets `is_full` to whether
  /// this process or the system has too many open files.
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

// The operating system: memory, processors, files, processes, modules and sockets.
//
// Only core/platform_*.cpp include headers of the system, one file for each section below (scripts/check_layers checks it). A
// port to another system rewrites these files and nothing else.
//
// Unless a declaration says otherwise, functions are thread-safe, and a failure is a std::error_code of the generic category.
// Where a system lacks a feature, the declaration states the answer instead: "unknown", infinity, no effect.
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

/// How many bytes of memory this process may still take: the least of what Linux has available without swapping (MemAvailable),
/// what the process's cgroups leave (versions 1 and 2, files in the page cache not counted), and what limits of the address
/// space and of data (ulimit -v, -d) leave beside the threads' stacks. Infinite if nothing is known. proc, cgroups: where these
/// file systems are mounted.
double available_memory_bytes(const std::filesystem::path& proc = "/proc",
                              const std::filesystem::path& cgroups = "/sys/fs/cgroup");

/// The most memory that this process has held so far; 0 if unknown.
std::uint64_t peak_memory_bytes();

/// The limit of the main thread's stack, which threads get too; none if it is unlimited or unknown.
std::optional<std::uint64_t> stack_limit_bytes();

/// Requests huge pages for memory that is reserved and not yet written, so that random reads miss the translation cache less
/// often. Has no effect where the system has none, or below some megabytes.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// Reserves room for `count` values, in huge pages where possible.
template <class T>
void reserve_huge(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  prefer_huge_pages(values.data(), count * sizeof(T));
}

// ---- Processors, clocks, the machine (platform_machine.cpp) ---------------------------------------------------------------

/// The processor's name, for figures of time; "unknown" where the system does not report one.
std::string cpu_model();

/// Processors that this process may run on, by its affinity; at least 1.
int usable_cpus();
/// Processors that the machine has switched on; at least 1.
int online_cpus();

/// Flushes denormals to zero in this thread, as inputs and as results (MXCSR on x86, FPCR on ARM64; no effect elsewhere).
/// Returns the control register as it was, for restore_float_control().
unsigned flush_denormals();
void restore_float_control(unsigned control);

/// CPU seconds of this process (all threads) or of the calling thread since it began.
double process_cpu_seconds();
double thread_cpu_seconds();

/// The CPU clock of the thread that makes it. Other threads may read it while that thread lives.
class ThreadClock {
 public:
  ThreadClock();
  double seconds() const;

 private:
  std::int64_t clock_;
};

/// The machine's name as the system reports it; empty if it has none.
std::string machine_name();
/// The same in at most 64 letters, digits and dashes, for names of files that several machines write into one folder; "host" if
/// nothing is left.
std::string host_name();
/// The system's name and version, as in "Linux 6.1.0".
std::string system_name();

/// 32 random bits from the system; 0 if it has no source of them.
std::uint32_t random_bits();

// ---- Files (platform_files.cpp) -------------------------------------------------------------------------------------------

/// An open file, or none. Not thread-safe but for renew().
class OpenFile {
 public:
  enum class Mode {
    kRead,    ///< an existing file; opening a FIFO does not wait for its writer
    kCreate,  ///< a new file, to write and read; fails if the name is taken
    kAppend,  ///< a new file whose end every write goes to; fails if the name is taken
  };

  OpenFile() = default;
  OpenFile(const std::filesystem::path& path, Mode mode, std::error_code& problem);
  ~OpenFile() { static_cast<void>(close()); }
  OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept;

  bool is_open() const { return descriptor_ >= 0; }

  /// Returns the kind of file; `bytes` gets its size.
  std::filesystem::file_type kind(std::uintmax_t& bytes, std::error_code& problem) const;

  /// Reads `count` bytes, or fewer at the file's end and after a failure. Returns how many.
  std::size_t read(void* to, std::size_t count, std::error_code& problem);
  /// Writes all bytes.
  std::error_code write(const void* from, std::size_t count);
  /// Moves to `offset` from the begin (SEEK_SET), the place (SEEK_CUR) or the end (SEEK_END) of the file. Returns the new
  /// place; -1 if it cannot.
  std::int64_t seek(std::int64_t offset, int whence);
  /// Waits until all bytes are on the disk. File systems without such a wait are taken as they are.
  std::error_code sync();
  /// Closes the file. An error of a delayed write may show here only.
  std::error_code close();

  /// Whether the path still leads to this file.
  bool is_at(const std::filesystem::path& path) const;
  /// Sets the time of the last change to now, which is how a lease is renewed. May run beside other calls.
  void renew() const;

 private:
  int descriptor_ = -1;
};

/// Waits until a file's bytes (or a folder's names) are on the disk, so that they survive a loss of power. Throws Error naming
/// the file where they cannot be written. File systems without such a wait, and folders that may not be read, are taken as they
/// are. An empty folder name is the working folder.
void sync_file(const std::filesystem::path& file);
void sync_folder(const std::filesystem::path& folder);

/// Why no file can be made in a folder that exists; no error if one can.
std::error_code check_writable(const std::filesystem::path& folder);

/// Removes a file and never a folder. A file that cannot be removed stays.
void remove_file(const std::filesystem::path& file);

/// Makes a new empty file or folder, named `prefix` and random letters, that only this user can read.
std::filesystem::path make_unique_file(const std::filesystem::path& prefix, std::error_code& problem);
std::filesystem::path make_unique_folder(const std::filesystem::path& prefix, std::error_code& problem);

// ---- Processes (platform_process.cpp) -------------------------------------------------------------------------------------

/// This process's number.
int process_id();
/// Whether no process has that number.
bool is_process_gone(int process);

/// Another process of this machine. The handle stays with that process, even if another gets its number later. Where a system
/// cannot look into processes, every process is there and none is visible.
class ProcessHandle {
 public:
  explicit ProcessHandle(int process);
  ~ProcessHandle();
  ProcessHandle(const ProcessHandle&) = delete;
  ProcessHandle& operator=(const ProcessHandle&) = delete;

  bool is_there() const { return descriptor_ >= 0; }
  /// Whether this process may list that one's open files.
  bool is_visible() const;
  /// Whether it has the file open for writing, as far as it is visible.
  bool writes(const std::filesystem::path& file) const;
  /// Does what Ctrl-C does. Returns whether it could.
  bool interrupt() const;

 private:
  int process_, descriptor_;
};

struct ChildCommand {
  std::vector<std::string> words;       ///< the program, sought in PATH unless it is a path, and its arguments
  std::filesystem::path folder = {};    ///< to run in; empty: this process's
  bool is_silent = false;               ///< its input is empty and what it prints is dropped
  std::filesystem::path messages = {};  ///< of a silent child: an existing file that its standard error is appended to
};

/// A program that this process has started. Not thread-safe.
class ChildProcess {
 public:
  ChildProcess(const ChildCommand& command, std::error_code& problem);
  /// Waits for its end.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool is_running();
  /// Does what Ctrl-C does.
  void interrupt();
  /// Waits for its end. Returns its exit code, or 128 and the number of the signal that ended it.
  int wait();
  /// CPU seconds of the process, after its end.
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  bool has_ended(int options);

  int process_ = 0;  ///< 0: it has ended, or never began
  int exit_code_ = 0;
  double cpu_seconds_ = 0.0;
};

/// Opens an address in the user's browser, which may run for days. Returns whether one could be started.
bool open_in_browser(const std::string& address);

/// Whether standard error is a terminal.
bool is_stderr_terminal();

/// Opens standard streams that were closed at the start, with nothing behind them. Otherwise the next file that is opened would
/// take the place of one.
void open_missing_streams();

/// Makes writing to a closed pipe, or beyond the limit on the size of files, an error of that write instead of a signal that
/// ends the process.
void ignore_write_signals();

// ---- Modules (platform_modules.cpp) ---------------------------------------------------------------------------------------

/// The running program's file; empty if unknown.
std::filesystem::path program_file();
/// The file, program or shared library, that contains the code at an address; empty if unknown.
std::filesystem::path file_of_code(const void* address);

/// Loads a shared library for the rest of the process, its symbols hidden from others. Returns null and a message if it cannot.
void* load_library(const std::filesystem::path& file, std::string& problem);
/// The address of a symbol of a loaded library; null if it has none of that name.
void* find_symbol(void* library, const char* name);

// ---- Sockets (platform_sockets.cpp) ---------------------------------------------------------------------------------------

/// A TCP socket, or none. No call waits. Not thread-safe.
class Socket {
 public:
  struct Transfer {
    std::size_t bytes = 0;
    bool is_over = false;  ///< the other end has closed, or the connection failed; otherwise no bytes: try later
  };

  Socket() = default;
  /// Takes a socket of the system, which does not block.
  explicit Socket(std::intptr_t handle) : handle_(handle) {}
  ~Socket() { close(); }
  Socket(Socket&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  Socket& operator=(Socket&& other) noexcept;

  /// Listens at the first address of the host that can be listened at; port 0: any that is free. Returns none if there is none.
  static Socket listen(const std::string& host, int port);

  bool is_open() const { return handle_ >= 0; }
  std::intptr_t handle() const { return handle_; }
  /// The port of this end; 0 if it has none.
  int port() const;

  /// Takes a connection of a listening socket; none if none waits. `is_full` gets whether this process has too many files open.
  Socket accept(bool& is_full) const;
  Transfer receive(std::span<char> to);
  /// more_follows: the system may wait with the last packet.
  Transfer send(std::string_view bytes, bool more_follows);
  /// Tells the other end that no more bytes come.
  void end_sending();

 private:
  void close();

  std::intptr_t handle_ = -1;
};

/// Wakes a thread in wait_for_any() from another thread.
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
  bool is_ready = false;  ///< it happened, or the socket failed
};

/// Waits until one of the events happens, at most for `timeout`. Returns whether one did.
bool wait_for_any(std::span<WatchedSocket> sockets, std::chrono::milliseconds timeout);

}  // namespace lippmann::platform

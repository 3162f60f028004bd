// Simulates machines that share a disk, and processes that run real code. Before each system call for a file below
// /sim/, another process may continue. A seed determines the order of processes and the failures. The system calls of a
// killed process fail, so that it ends without effect.
#pragma once

#include <ucontext.h>
#include <csetjmp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simulation/disk.hpp"
#include "simulation/random.hpp"

namespace lippmann::test {

/// A number n lets its failure happen once in n system calls on average, or never if n is 0.
struct Faults {
  std::size_t kill = 0, machine_loss = 0, power_loss = 0;
  std::size_t disk_full = 0;
  std::size_t error = 0;  ///< a write fails with EIO or ENOSPC
  std::size_t read_error = 0;
  std::size_t interrupted = 0;  ///< a call fails with EINTR, or reads or writes only a part
  std::size_t clock_jump = 0;
  std::size_t flipped_byte = 0;
};

struct Process {
  int id = 0, machine = 0, pid = 1;
  bool is_dead = false, has_ended = false;
  bool has_misread = false;
  std::uint64_t began = 0;  ///< step of the simulation at which the process began
  std::function<void()> body;
  bool has_begun = false;
  ucontext_t context{};
  std::jmp_buf place{};
  std::array<std::byte, 16> exceptions{};  ///< exceptions that the process is handling, stored by the C++ run-time
  std::unique_ptr<std::byte[]> stack;
};

class World {
 public:
  World(std::uint64_t seed, int machines, bool share_a_name);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Runs all processes to their end. Calls `ready`, which may start processes, between system calls.
  void run(const std::function<void()>& ready = {});
  Process& start(int machine, std::function<void()> body);

  /// Called before every system call. Lets other processes run. Returns the errno with which the call must fail, or 0.
  enum class Call { kRead, kWrite, kOther };
  int before(Call call);

  void calm() { faults = {}, full_until_ = 0; }

  void pass(std::int64_t nanoseconds);

  /// Returns how many of `bytes` bytes this call reads or writes.
  std::size_t moved(std::size_t bytes);

  Process* current() { return current_; }
  std::string machine_name(int machine) const;
  bool is_alive(int machine, int pid) const;
  std::int64_t nanoseconds(int machine) const;
  std::size_t running() const { return processes_.size(); }

  Disk disk;
  Random random;
  Faults faults;
  std::uint64_t steps = 0, last_flip = 0;
  std::function<bool(const std::string&)> flips;
  std::string log;

 private:
  void resume(Process& process);
  void go_to(Process& process);
  void let_others_go_on();
  void happen();
  void kill_some(int machine);
  void flip_a_byte();
  [[noreturn]] static void enter();

  std::vector<std::unique_ptr<Process>> processes_;
  std::vector<std::unique_ptr<std::byte[]>> stacks_;
  std::vector<std::int64_t> clocks_;
  bool share_a_name_;
  Process* current_ = nullptr;
  std::jmp_buf scheduler_{};
  std::uint64_t full_until_ = 0;
  int next_id_ = 0;
};

/// If null, all calls go to the operating system.
World*& world();

}  // namespace lippmann::test

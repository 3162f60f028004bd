// Machines that share a disk, their clocks, and processes that run on them one system call at a time. The processes run real
// code, whose calls (calls.cpp) come here for files below /sim/. A seed decides which process runs next, and what fails when.
//
// A killed process has no more visible effects: its calls fail, so that it soon ends and frees its memory.
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

/// Frequency of faults, once in this many system calls; 0: never.
struct Faults {
  std::size_t kill = 0, machine_loss = 0, power_loss = 0;
  std::size_t disk_full = 0;  ///< from then on, for a while
  std::size_t error = 0;      ///< EIO or ENOSPC of a call that writes
  std::size_t read_error = 0;
  std::size_t interrupted = 0;  ///< EINTR, and partial reads and writes
  std::size_t clock_jump = 0;
  std::size_t flipped_byte = 0;  ///< in a picture
};

struct Process {
  int id = 0, machine = 0, pid = 1;
  bool is_dead = false, has_ended = false;
  bool has_misread = false;  ///< one of its reads has failed
  std::uint64_t began = 0;   ///< step of the world
  std::function<void()> body;
  bool has_begun = false;
  ucontext_t context{};                    ///< its entry point
  std::jmp_buf place{};                    ///< where it continues
  std::array<std::byte, 16> exceptions{};  ///< exceptions being caught, from the C++ run-time
  std::unique_ptr<std::byte[]> stack;
};

class World {
 public:
  World(std::uint64_t seed, int machines, bool share_a_name);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Runs until all processes have ended. Calls `ready` between system calls, which may start processes.
  void run(const std::function<void()>& ready = {});
  Process& start(int machine, std::function<void()> body);

  /// Called before every system call of a process; lets others run. Returns an errno with which the call fails, or 0.
  enum class Call { kRead, kWrite, kOther };
  int before(Call call);

  /// Disables all faults from here on.
  void calm() { faults = {}, full_until_ = 0; }

  /// Sets all clocks forward.
  void pass(std::int64_t nanoseconds);

  /// Returns the number of bytes that this call transfers, of `bytes`.
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
  std::function<bool(const std::string&)> flips;  ///< returns whether a file may be damaged, by its path
  std::string log;                                ///< faults that occurred, for people

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

/// The world that system calls go to; null: all go to the real one.
World*& world();

}  // namespace lippmann::test

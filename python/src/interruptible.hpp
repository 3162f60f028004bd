// Runs long work of the library such that Python stays alive meanwhile: its other threads run, Ctrl-C stops the work, and
// callbacks are called in the thread that asked for it.
//
// The work runs in a thread of its own, without the interpreter's lock. The thread that called waits, and takes the lock every
// 50 ms to hand on what the work has reported and to look for signals. Where a callback throws, or a signal does
// (KeyboardInterrupt), Context::cancelled is set; the exception is raised once the work has stopped.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann::python {

class Interruptible {
 public:
  /// threads: 0: one per processor.
  explicit Interruptible(int threads);

  /// Calls work(context()) and raises what it throws. `progress`: None, or called with the share of a frame that is done.
  /// Throws Error where another thread's work is under way. The lock is held by the caller.
  void run(const py::object& progress, const std::function<void(const Context&)>& work);

  const Context& context() const { return context_; }

 private:
  void wait_for(const py::object& progress, const std::function<bool()>& ended);
  void hand_on(const py::object& progress);

  Context context_;
  std::atomic<double> share_{0.0};
  std::mutex mutex_;  ///< of warnings_
  std::vector<std::string> warnings_;
  std::atomic<bool> busy_{false};
};

}  // namespace lippmann::python

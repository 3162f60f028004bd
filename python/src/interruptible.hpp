// Runs long work so that other Python threads can run, Ctrl-C can stop the work, and callbacks run on the calling thread.
//
// The work runs in a thread without the interpreter's lock. Every 50 ms, the calling thread takes the lock, calls the callbacks
// and checks for signals. If a callback or a signal raises an exception, Context::cancelled is set, and the exception is passed
// on when the work has stopped.
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
  explicit Interruptible(int threads);

  /// Calls work(context()) and passes on its exception. progress: None, or a function of the rendered share of the current
  /// frame. Throws Error if another thread is in this function. The caller must hold the interpreter's lock.
  void run(const py::object& progress, const std::function<void(const Context&)>& work);

  const Context& context() const { return context_; }

 private:
  void wait_for(const py::object& progress, const std::function<bool()>& ended);
  void hand_on(const py::object& progress);

  Context context_;
  std::atomic<double> share_{0.0};
  std::mutex mutex_;  ///< guards warnings_
  std::vector<std::string> warnings_;
  std::atomic<bool> busy_{false};
};

}  // namespace lippmann::python

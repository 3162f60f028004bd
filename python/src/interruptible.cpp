#include "interruptible.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <thread>
#include <utility>

#include "lippmann/core/error.hpp"

namespace lippmann::python {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(50);

/// Marks an animation as busy while this object exists.
class Busy {
 public:
  explicit Busy(std::atomic<bool>& flag) : flag_(flag) {
    if (flag_.exchange(true))
      throw Error("thread", "another thread is rendering a frame of the same animation",
                  "one thread at a time, or an animation for each");
  }
  ~Busy() { flag_ = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  std::atomic<bool>& flag_;
};

class Task {
 public:
  explicit Task(std::function<void()> work) : thread_([this, work = std::move(work)] { run(work); }) {}
  ~Task() {
    if (thread_.joinable()) thread_.join();
  }
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  bool has_ended() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPeriod, [this] { return ended_; });
  }

  /// Rethrows the exception of the task, if there is one. Call after the task has ended.
  void rethrow() {
    thread_.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void run(const std::function<void()>& work) {
    try {
      work();
    } catch (...) {
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  ///< declared last, since the thread uses the other members
};

}  // namespace

Interruptible::Interruptible(int threads) {
  context_.threads = threads;
  context_.frame_progress = [this](double share) { share_ = share; };
  context_.warn = [this](std::string_view text) {
    const std::lock_guard lock(mutex_);
    warnings_.emplace_back(text);
  };
}

void Interruptible::hand_on(const py::object& progress) {
  std::vector<std::string> warnings;
  {
    const std::lock_guard lock(mutex_);
    warnings.swap(warnings_);
  }
  for (const std::string& text : warnings) py::module_::import("lippmann._errors").attr("warn")(py::bytes(text));
  if (!progress.is_none()) progress(share_.load());
}

void Interruptible::wait_for(const py::object& progress, const std::function<bool()>& ended) {
  std::exception_ptr raised;
  for (bool done = false; !done;) {
    {
      const py::gil_scoped_release release;
      done = ended();
    }
    if (raised) continue;
    try {
      hand_on(progress);
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    } catch (...) {
      raised = std::current_exception();
      context_.cancelled = true;
    }
  }
  if (raised) std::rethrow_exception(raised);
}

void Interruptible::run(const py::object& progress, const std::function<void(const Context&)>& work) {
  const Busy busy(busy_);
  context_.cancelled = false;
  share_ = 0.0;
  Task task([&] { work(context_); });
  wait_for(progress, [&] { return task.has_ended(); });
  task.rethrow();
}

}  // namespace lippmann::python

#include "lippmann/core/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <thread>

#include "core/platform.hpp"
#include "core/task_order.hpp"

namespace lippmann {

int resolved_threads(const Context& context) { return context.threads > 0 ? context.threads : platform::usable_cpus(); }

DenormalsAreZero::DenormalsAreZero() : saved_(platform::flush_denormals()) {}
DenormalsAreZero::~DenormalsAreZero() { platform::restore_float_control(saved_); }

namespace {

/// Sums the CPU time of worker threads inside an arena. A thread's clock can be read while the thread is inside, because
/// threads leave the arena before they end.
class CpuMeter : public tbb::task_scheduler_observer {
 public:
  explicit CpuMeter(tbb::task_arena& arena) : task_scheduler_observer(arena) { observe(true); }
  /// Waits for workers that are entering or leaving the arena.
  ~CpuMeter() override {
    observe(false);
    order_.all_ended();
  }

  void on_scheduler_entry(bool is_worker) override {
    if (!is_worker) return;
    order_.begin();
    const platform::ThreadClock clock;
    enter({clock, clock.seconds()});
    order_.end();
  }

  void on_scheduler_exit(bool is_worker) override {
    if (!is_worker) return;
    leave();
    order_.end();
  }

  double seconds() const {
    const std::lock_guard lock(mutex_);
    double sum = left_;
    for (const auto& [thread, visit] : inside_) sum += visit.clock.seconds() - visit.start;
    return sum;
  }

 private:
  struct Visit {
    platform::ThreadClock clock;
    double start;
  };

  void enter(const Visit& visit) {
    const std::lock_guard lock(mutex_);
    inside_.insert_or_assign(std::this_thread::get_id(), visit);
  }

  void leave() {
    const std::lock_guard lock(mutex_);
    const auto visit = inside_.find(std::this_thread::get_id());
    if (visit == inside_.end()) return;
    left_ += visit->second.clock.seconds() - visit->second.start;
    inside_.erase(visit);
  }

  TaskOrder order_;
  mutable std::mutex mutex_;
  std::map<std::thread::id, Visit> inside_;
  double left_ = 0.0;
};

}  // namespace

struct ThreadPool::Impl {
  explicit Impl(int threads)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads, 1),
        workers(arena) {}
  tbb::global_control limit;
  tbb::task_arena arena;
  CpuMeter workers;
};

ThreadPool::ThreadPool(int threads) : impl_(std::make_unique<Impl>(std::max(1, threads))), threads_(std::max(1, threads)) {}
ThreadPool::~ThreadPool() = default;

void ThreadPool::for_each(std::size_t count, const std::function<void(std::size_t)>& fn) const {
  TaskOrder order;
  impl_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          const DenormalsAreZero flush;
          order.begin();
          for (std::size_t i = range.begin(); i != range.end(); ++i) fn(i);
          order.end();
        },
        tbb::simple_partitioner());
  });
  order.all_ended();
}

void ThreadPool::run(const std::function<void()>& fn) const {
  TaskOrder order;
  impl_->arena.execute([&] {
    const DenormalsAreZero flush;
    order.begin();
    fn();
    order.end();
  });
  order.all_ended();
}

double ThreadPool::cpu_seconds() const { return platform::thread_cpu_seconds() + impl_->workers.seconds(); }

}  // namespace lippmann

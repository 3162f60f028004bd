// Runs independent pieces of work on the context's threads. This interface hides the task library (oneTBB).
//
// Results are bit-identical for any number of threads if the caller follows three rules:
// 1. The division into pieces does not depend on the number of threads.
// 2. Each piece writes only its own data.
// 3. Reductions happen after all pieces, in the order of the pieces.
//
// Worker threads flush denormals to zero, as Embree recommends.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "lippmann/core/context.hpp"

namespace lippmann {

/// Create one per process or render, because creating a pool takes longer than tracing a small frame.
class ThreadPool {
 public:
  explicit ThreadPool(int threads);  ///< threads >= 1, including the calling thread
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const { return threads_; }

  /// Calls fn(0) ... fn(count - 1), each exactly once, in any order, and returns when all have finished. Rethrows the first
  /// exception from fn after the others have finished.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& fn) const;

  /// Runs fn on this pool's threads, so that libraries that use oneTBB internally (Embree's builders) use only this pool.
  void run(const std::function<void()>& fn) const;

  /// Returns the CPU seconds of the calling thread plus those that other threads spent on this pool's work. Threads that write
  /// files are not included.
  double cpu_seconds() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  int threads_;
};

/// Flushes denormals to zero in this thread during the object's lifetime, on x86 and ARM64.
class DenormalsAreZero {
 public:
  DenormalsAreZero();
  ~DenormalsAreZero();
  DenormalsAreZero(const DenormalsAreZero&) = delete;
  DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

 private:
  unsigned saved_;
};

}  // namespace lippmann

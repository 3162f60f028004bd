// Runs independent pieces of work on the context's threads. The only header behind which the task library (oneTBB) hides.
//
// Rules that keep results bit-identical for any number of threads: the pieces are fixed by the caller, never by the thread
// count; a piece writes only what is its own; reductions are made by the caller afterwards, in the order of the pieces.
// Worker threads run with denormals flushed to zero (Embree asks for it, and it makes results independent of the caller).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "lippmann/core/context.hpp"

namespace lippmann {

/// Threads to run on, set up once per process or render (creating them per frame costs more than a small frame).
class ThreadPool {
 public:
  explicit ThreadPool(int threads);  ///< threads >= 1, the calling thread counted
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const { return threads_; }

  /// Calls fn(0) ... fn(count - 1), each exactly once, in any order, and returns when all have ended. The first exception
  /// that fn throws is rethrown here after the others have ended.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& fn) const;

  /// Runs fn on this pool's threads, so that libraries that use oneTBB inside (Embree's builders) stay within it.
  void run(const std::function<void()>& fn) const;

  /// CPU seconds that the calling thread has spent so far, and the other threads on this pool's work. The difference of two
  /// calls is what the work between them cost, whatever else the process did meanwhile (writing files).
  double cpu_seconds() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  int threads_;
};

/// Flushes denormals to zero in this thread for the life of the object on x86 and ARM64, then restores.
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

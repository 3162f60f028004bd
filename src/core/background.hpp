// Runs a bounded number of pieces of work on separate threads, for example to compress and write files while the next frame is
// traced.
//
// oneTBB's flow graph is not suitable, although its sequencer and limiter nodes provide the same order and bound, because its
// tasks run on the tracing workers, one per core. A task that waits for a disk would block its worker, and while all workers
// trace, finished frames would pile up. With separate threads, the operating system schedules both.
#pragma once

#include <functional>
#include <memory>

namespace lippmann {

/// Each piece has two halves: `work` runs on any thread, in any order; `in_order` runs after it, one at a time, in the order of
/// submission (a video needs its frames in order). Either may be empty. Call all members from one thread.
///
/// The first exception of a piece stops the queue: pieces that have not started are dropped, and the next submit() or finish()
/// rethrows the exception once.
class BackgroundQueue {
 public:
  /// threads >= 1. capacity >= 1: maximum number of existing pieces, including running ones, which bounds the memory of their
  /// images. Throws std::system_error if the system has no more threads.
  BackgroundQueue(int threads, int capacity);
  /// Drops the pieces that have not started, and waits for the others.
  ~BackgroundQueue();
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  /// Waits until fewer than `capacity` pieces exist, then queues a new one. If the piece throws, a later call of submit() or
  /// finish() reports it.
  void submit(std::function<void()> work, std::function<void()> in_order = {});

  /// Waits until all pieces have finished.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

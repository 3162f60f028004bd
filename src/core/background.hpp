// Runs pieces of work on separate threads, for example to compress and write files while the next frame is traced.
//
// oneTBB's flow graph is not suitable because its tasks would run on the same worker threads as ray tracing, one per core. A
// task that waits for a disk would block its worker. While all workers trace, finished frames would pile up. With separate
// threads, the operating system schedules tracing and writing.
#pragma once

#include <functional>
#include <memory>

namespace lippmann {

/// Each piece has two functions. `work` runs on any thread, in any order. `in_order` runs after `work` of the same piece. The
/// in_order functions run one at a time, in the order of submission, as the frames of a video require. Either function may be
/// empty. Call all members from one thread.
///
/// The first exception of a piece stops the queue. Pieces that have not started are dropped. The next submit() or finish()
/// rethrows the exception once.
class BackgroundQueue {
 public:
  /// `threads` and `capacity` are at least 1. At most `capacity` pieces wait or run at a time, which bounds the memory of their
  /// images. Throws std::system_error if the system has no more threads.
  BackgroundQueue(int threads, int capacity);
  /// Drops the pieces that have not started. Waits for the running pieces.
  ~BackgroundQueue();
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  /// Waits until fewer than `capacity` pieces wait or run, then queues a new piece.
  void submit(std::function<void()> work, std::function<void()> in_order = {});

  /// Waits until all pieces have finished.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

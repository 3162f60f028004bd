// Runs pieces of work on threads of their own, beside the caller, a bounded number at a time: compressing and writing files
// while the next frame is traced.
//
// Not oneTBB's flow graph, though its sequencer and limiter nodes order and bound just so: its tasks run on the workers that
// trace, of which there are as many as cores. Writing waits for disks, and a task that waits holds its worker; and where all
// workers trace, written frames pile up behind them. Threads of their own leave both to the operating system.
#pragma once

#include <functional>
#include <memory>

namespace lippmann {

/// Each piece has two halves: `work` runs on any of the threads, in any order; `in_order` runs after it, one at a time, in the
/// order of submission (a video takes its frames so). Either may be empty. All members are called from one thread.
///
/// The first exception that a piece throws ends the queue: pieces not yet begun are dropped, and the next submit() or finish()
/// rethrows it, once.
class BackgroundQueue {
 public:
  /// threads >= 1; capacity >= 1: how many pieces may exist at a time, those being worked on included. What pieces hold
  /// (pictures) is thereby bounded. Throws std::system_error where the system has no more threads.
  BackgroundQueue(int threads, int capacity);
  /// Drops the pieces not yet begun and waits for the others.
  ~BackgroundQueue();
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  /// Waits while `capacity` pieces exist, then queues this one; its own failure is reported by a later call.
  void submit(std::function<void()> work, std::function<void()> in_order = {});

  /// Waits until every piece has ended.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

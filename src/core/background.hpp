#pragma once

#include <functional>
#include <memory>

namespace lippmann {

/// Each piece of work has two functions. `work` runs on any thread, in any order. `in_order` runs after `work`; the in_order
/// functions of all pieces run one at a time, in the order of submission. Either function may be empty. Call all members from
/// one thread.
///
/// The first exception of a piece stops the queue. Pieces that have not started are dropped. The next submit() or finish()
/// rethrows the exception once.
class BackgroundQueue {
 public:
  /// At most `capacity` pieces wait or run at a time; with this many pieces, submit() waits until one has ended. The destructor
  /// drops the pieces that have not started, and waits for the running ones. Throws std::system_error if the system has no more
  /// threads.
  BackgroundQueue(int threads, int capacity);
  ~BackgroundQueue();
  BackgroundQueue(const BackgroundQueue&) = delete;
  BackgroundQueue& operator=(const BackgroundQueue&) = delete;

  void submit(std::function<void()> work, std::function<void()> in_order = {});

  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann

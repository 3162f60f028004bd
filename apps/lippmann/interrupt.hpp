// Turns Ctrl-C and `kill` into the context's `cancelled`, so that work stops between frames and leaves only whole files.
#pragma once

#include <atomic>

namespace lippmann::app {

/// While it lives, the first SIGINT or SIGTERM sets `cancelled`; a second one ends the process at once. At most one at a time.
class InterruptGuard {
 public:
  explicit InterruptGuard(std::atomic<bool>& cancelled);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// 128 + the signal's number, as shells report it, once one has arrived; else 0.
  static int exit_code();
};

}  // namespace lippmann::app

// Turns Ctrl-C and `kill` into the context's `cancelled`, so that work stops between frames and leaves only complete files.
#pragma once

#include <atomic>

namespace lippmann::app {

/// While this exists, the first SIGINT or SIGTERM sets `cancelled`; a second one ends the process at once. Only one may exist.
class InterruptGuard {
 public:
  explicit InterruptGuard(std::atomic<bool>& cancelled);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Returns 128 + the signal's number, as shells report it, or 0 if no signal has arrived.
  static int exit_code();
};

}  // namespace lippmann::app

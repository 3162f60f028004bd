// On Ctrl-C or `kill`, stops work between frames and leaves only complete files.
#pragma once

#include <atomic>

namespace lippmann::app {

/// While an object of this class exists, the first SIGINT or SIGTERM sets `cancelled`, and a second one ends the process. Only
/// one object may exist.
class InterruptGuard {
 public:
  explicit InterruptGuard(std::atomic<bool>& cancelled);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Returns 128 + the number of the signal that arrived, as shells report it, or 0 if none arrived.
  static int exit_code();
};

}  // namespace lippmann::app

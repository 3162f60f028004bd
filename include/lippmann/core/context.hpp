// The caller's settings for long operations: number of threads, destinations of warnings and progress, and cancellation.
//
// A Context is passed by reference from main() down; the library has no global state. All callbacks may be empty.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace lippmann {

struct Context {
  int threads = 0;  ///< worker threads; 0: one per processor that this process may use
  /// Receives one complete sentence per call, without newline; called from any thread.
  std::function<void(std::string_view)> warn{};
  /// Receives the traced fraction of the current frame, 0 to 1. Called often, from any thread. If a requested frame needs other
  /// frames first, such as key frames, the fraction restarts from 0 for each of these frames.
  std::function<void(double)> frame_progress{};
  std::atomic<bool> cancelled{false};  ///< set to true to stop at the next tile or frame; signal handlers may set it

  void warning(std::string_view text) const {
    if (warn) warn(text);
  }
};

/// Returns context.threads, or, if it is 0, the number of processors that this process may use.
int resolved_threads(const Context& context);

}  // namespace lippmann

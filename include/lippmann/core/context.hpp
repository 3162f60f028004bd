// What long work gets from its caller: how many threads it may use, where warnings and progress go, whether to stop.
//
// A Context is passed by reference from main() down; nothing in the library is global. All callbacks may be empty.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace lippmann {

struct Context {
  int threads = 0;                             ///< worker threads; 0 = one per processor that this process may use
  std::function<void(std::string_view)> warn;  ///< one complete sentence per call, no newline; any thread
  /// Share of the frame under way that is traced, 0 to 1; any thread, often. It begins anew for every frame that the requested
  /// one needs: the key frames around an interpolated one.
  std::function<void(double)> frame_progress;
  std::atomic<bool> cancelled{false};  ///< set (from a signal handler too) to stop at the next tile or frame

  /// Reports to `warn` if it is set.
  void warning(std::string_view text) const {
    if (warn) warn(text);
  }
};

/// The number of threads that `context` asks for, resolved: >= 1.
int resolved_threads(const Context& context);

}  // namespace lippmann

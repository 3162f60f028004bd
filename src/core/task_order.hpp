// Declares to ThreadSanitizer the order of tasks in libraries that are built without it: a task runs after everything that was
// done before it was started, and before everything that is done after all tasks have ended.
#pragma once

// Active in instrumented sources, and in one source that is not instrumented (core/CMakeLists.txt).
#if defined(__SANITIZE_THREAD__) || defined(LIPPMANN_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#define LIPPMANN_TELLS_TASK_ORDER
#endif

namespace lippmann {

class TaskOrder {
 public:
#ifdef LIPPMANN_TELLS_TASK_ORDER
  TaskOrder() { all_begin(); }
  /// Call this before starting tasks, if something was done since this object was constructed that the tasks must see.
  void all_begin() { __tsan_release(&begun_); }
  void begin() { __tsan_acquire(&begun_); }
  void end() { __tsan_release(&ended_); }
  void all_ended() { __tsan_acquire(&ended_); }

 private:
  char begun_ = 0, ended_ = 0;
#else
  void all_begin() {}
  void begin() {}
  void end() {}
  void all_ended() {}
#endif
};

}  // namespace lippmann

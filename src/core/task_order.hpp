// What ThreadSanitizer cannot see of tasks in libraries that are built without it: they come after what was done before they
// were begun, and before what is done once all have ended.
#pragma once

// Of sources that are watched, and of one that says itself that it is not (core/CMakeLists.txt).
#if defined(__SANITIZE_THREAD__) || defined(LIPPMANN_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#define LIPPMANN_TELLS_TASK_ORDER
#endif

namespace lippmann {

class TaskOrder {
 public:
#ifdef LIPPMANN_TELLS_TASK_ORDER
  TaskOrder() { all_begin(); }
  /// For tasks that are begun later than this was made.
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

// Declares to ThreadSanitizer how a library that is built without it orders tasks. Each task runs between the calls of
// all_begin() and all_ended(), and calls begin() first and end() last.
#pragma once

// Enabled in sources that are compiled for ThreadSanitizer, and in parallel.cpp (see core/CMakeLists.txt).
#if defined(__SANITIZE_THREAD__) || defined(LIPPMANN_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#define LIPPMANN_TELLS_TASK_ORDER
#endif

namespace lippmann {

class TaskOrder {
 public:
#ifdef LIPPMANN_TELLS_TASK_ORDER
  TaskOrder() { all_begin(); }
  /// Call this before starting tasks if they read data written after this object was constructed.
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

// A render that was started from the page: it runs beside the server, tells how far it is, and can be cancelled.
#pragma once

#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <thread>

#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// One render at a time. Thread-safe.
class LiveRender {
 public:
  LiveRender() = default;
  /// Cancels it, and waits until it has ended.
  ~LiveRender();
  LiveRender(const LiveRender&) = delete;
  LiveRender& operator=(const LiveRender&) = delete;

  /// What render_animation does, in a thread of its own. `ended` is called when it has. Throws an Error where one runs already.
  void start(const ResolvedJob& job, std::function<void()> ended);

  /// Leaves what Ctrl-C leaves: finished frames, for `lippmann render job.toml --resume`.
  void cancel();

  bool is_running() const;

  /// "state" (running, finished, stopped, failed), "frames", "done", "share" of all, "seconds_left" (null: not known yet),
  /// "folder", "error"; null before the first.
  nlohmann::ordered_json json() const;

 private:
  void run(const ResolvedJob& job);

  mutable std::mutex mutex_;
  std::thread thread_;
  Context context_;
  std::string state_, folder_, error_;
  int frames_ = 0, done_ = 0;
  double share_ = 0.0;  ///< how much of the frame under way is traced
  double started_ = 0.0;
};

}  // namespace lippmann

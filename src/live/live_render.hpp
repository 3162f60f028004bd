// A render that the page starts. It runs in a thread, reports its progress and can be cancelled.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <thread>

#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

class LiveRender {
 public:
  LiveRender() = default;
  ~LiveRender();
  LiveRender(const LiveRender&) = delete;
  LiveRender& operator=(const LiveRender&) = delete;

  /// Runs render_animation() in a thread, and then `ended`. Throws Error if a render is running.
  void start(const ResolvedJob& job, std::function<void()> ended);

  /// Stops the render like Ctrl-C. Finished frames remain for `lippmann render job.toml --resume`.
  void cancel();

  bool is_running() const;

  /// Returns the folder of the last render; nullopt if it has not finished.
  std::optional<std::filesystem::path> finished_folder() const;

  /// Returns the state of the render for the page: "state" (running, finished, stopped or failed), "frames", "done", "share"
  /// (finished fraction of the whole render), "seconds_left" (null if not known yet), "folder" and "error". Returns null before
  /// the first render.
  nlohmann::ordered_json json() const;

 private:
  void run(const ResolvedJob& job);

  mutable std::mutex mutex_;
  std::thread thread_;
  Context context_;
  std::string state_, folder_, error_;
  int frames_ = 0, done_ = 0;
  double share_ = 0.0;  ///< fraction of the current frame that is traced
  double started_ = 0.0;
};

}  // namespace lippmann

// Prints the progress of `lippmann render` on stderr: first the plan, then the frames done.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "apps/lippmann/progress.hpp"
#include "job/animation.hpp"

namespace lippmann::app {

enum class RenderProgressKind {
  kAuto,  ///< a bar on a terminal, otherwise a line from time to time
  kVerbose,
  kJson,  ///< JSON objects; docs/reference/formats.md lists the keys
  kNone
};

/// Receives the progress of one render. traced() and written() are called on different threads.
class RenderProgress {
 public:
  RenderProgress(const RenderPlan& plan, const RenderParams& params, RenderProgressKind kind);
  ~RenderProgress();
  RenderProgress(const RenderProgress&) = delete;
  RenderProgress& operator=(const RenderProgress&) = delete;

  void traced(const FrameReport& frame);
  void written(int frame, std::uintmax_t bytes);
  /// Sets the traced share of the current frame, from 0 to 1. Thread-safe.
  void within(double share);

 private:
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double estimated_bytes() const;
  void print_object(int frame) const;
  void tick();

  RenderProgressKind kind_;
  bool interpolates_;
  /// Numbers of frames or strips: in the plan, to be rendered by this run, and written so far.
  int frames_ = 0, wanted_ = 0, written_ = 0;
  double bytes_ = 0.0;
  double estimated_at_first_ = 0.0, video_bytes_ = 0.0;
  Clock::time_point start_ = Clock::now();
  LineSchedule schedule_;
  double within_ = 0.0;
  std::mutex mutex_;
  std::map<int, std::string> lines_;  ///< lines to print for frames that are traced but not yet written
  std::unique_ptr<Progress> progress_;
  std::optional<Heartbeat> heartbeat_;  ///< declared last, so that it stops before the other members are destroyed
};

}  // namespace lippmann::app

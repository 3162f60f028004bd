// What `lippmann render` says on stderr while it renders: before the first frame what is going to be made, then how far it is.
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
  kAuto,     ///< a bar on a terminal, elsewhere a line now and then
  kVerbose,  ///< a line per frame
  kJson,     ///< an object per frame, and within long ones: docs/reference/formats.md has its keys
  kNone
};

/// Hears of one render. traced() and written() run in different threads.
class RenderProgress {
 public:
  /// Says what is going to be made.
  RenderProgress(const RenderPlan& plan, const RenderParams& params, RenderProgressKind kind);
  ~RenderProgress();
  RenderProgress(const RenderProgress&) = delete;
  RenderProgress& operator=(const RenderProgress&) = delete;

  void traced(const FrameReport& frame);
  void written(int frame, std::uintmax_t bytes);
  /// The frame under way is traced up to `share`, 0 to 1. Any thread.
  void within(double share);

 private:
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double estimated_bytes() const;
  void print_object(int frame) const;
  void tick();

  RenderProgressKind kind_;
  bool interpolates_;
  int frames_ = 0, wanted_ = 0, written_ = 0;  ///< or strips: in the plan; to be rendered now; on disk of those
  double bytes_ = 0.0;                         ///< what written_ frames take
  double estimated_at_first_ = 0.0, video_bytes_ = 0.0;
  Clock::time_point start_ = Clock::now();
  LineSchedule schedule_;             ///< when objects within frames are due
  double within_ = 0.0;               ///< how much of the frame under way is traced, for objects
  std::mutex mutex_;                  ///< all that changes
  std::map<int, std::string> lines_;  ///< for frames that are traced and not yet written
  std::unique_ptr<Progress> progress_;
  std::optional<Heartbeat> heartbeat_;  ///< last: beats while the others are there
};

}  // namespace lippmann::app

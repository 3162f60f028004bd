// Tells how a run goes: its observer, or the first rank of an MPI job, whose observer hears of all ranks.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>

#include "distribute/ranks.hpp"
#include "folder/journal.hpp"
#include "job/render_plan.hpp"
#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// Hears how a render goes. All functions may be empty; all but `written` are called in the thread that called
/// render_animation.
struct RenderObserver {
  std::function<void(const RenderPlan&)> planned;
  std::function<void(const FrameReport&)> traced;  ///< a frame, or a strip of one, in order; its files follow
  /// A frame's pictures and layers, or a strip, are on disk, of so many bytes; in order, one at a time, on any thread. Not of
  /// what is kept, and not of frames that are joined from strips.
  std::function<void(int frame, std::uintmax_t bytes)> written;
};

class RunProgress {
 public:
  /// `ranks`: null for a process that stands alone. Both outlive this object.
  RunProgress(const RenderObserver& observer, Ranks* ranks) : observer_(observer), ranks_(ranks) {}

  /// On the first rank: passes on what the others tell. Before Ranks::begin().
  void listen();

  void planned(const RenderPlan& plan) const;
  void traced(const FrameReport& frame);
  void written(int frame, std::uintmax_t bytes);
  void strip_written(const FrameReport& strip, std::uintmax_t bytes);

 private:
  bool speaks() const { return !ranks_ || ranks_->rank() == 0; }

  const RenderObserver& observer_;
  Ranks* const ranks_;
  std::mutex mutex_;
  std::map<int, WorkDone> traced_;  ///< by this rank, by frame: what the first rank is told once their files are written
};

}  // namespace lippmann

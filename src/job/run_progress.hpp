// Reports the progress of a run to its observer. In an MPI job, the first rank reports for all ranks.
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

/// Callbacks may be empty. All except `written` are called on the thread that called render_animation().
struct RenderObserver {
  std::function<void(const RenderPlan&)> planned;
  /// Called for each traced frame or strip, in order, before its files are written.
  std::function<void(const FrameReport&)> traced;
  /// Called when the files of a frame or strip are on disk, with their total size in bytes. The calls come one at a time and in
  /// order, but on any thread. Not called for kept frames and for frames that are joined from strips.
  std::function<void(int frame, std::uintmax_t bytes)> written;
};

class RunProgress {
 public:
  /// `ranks` is null for a single process. Both arguments must outlive this object.
  RunProgress(const RenderObserver& observer, Ranks* ranks) : observer_(observer), ranks_(ranks) {}

  /// Makes the first rank forward the progress of the other ranks. Call this before Ranks::begin().
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
  /// Work of this rank by frame, sent to the first rank when the files are written.
  std::map<int, WorkDone> traced_;
};

}  // namespace lippmann

#include "job/run_progress.hpp"

namespace lippmann {

void RunProgress::listen() {
  ranks_->listen([this](const WorkDone& done) {
    FrameReport frame;
    frame.frame = done.frame, frame.seconds = done.seconds, frame.rays.primary = done.rays;
    if (observer_.traced) observer_.traced(frame);
    if (observer_.written) observer_.written(done.frame, done.bytes);
  });
}

void RunProgress::planned(const RenderPlan& plan) const {
  if (observer_.planned) observer_.planned(plan);
}

void RunProgress::traced(const FrameReport& frame) {
  if (speaks()) {
    if (observer_.traced) observer_.traced(frame);
    return;
  }
  const std::lock_guard lock(mutex_);
  traced_[frame.frame] = {frame.frame, frame.seconds, frame.rays.total(), 0};
}

void RunProgress::written(int frame, std::uintmax_t bytes) {
  if (speaks()) {
    if (observer_.written) observer_.written(frame, bytes);
    return;
  }
  const std::lock_guard lock(mutex_);
  WorkDone& done = traced_[frame];
  done.bytes = bytes;
  ranks_->tell(done);
}

void RunProgress::strip_written(const FrameReport& strip, std::uintmax_t bytes) {
  if (!speaks()) return ranks_->tell({strip.frame, strip.seconds, strip.rays.total(), bytes});
  if (observer_.traced) observer_.traced(strip);
  if (observer_.written) observer_.written(strip.frame, bytes);
}

}  // namespace lippmann

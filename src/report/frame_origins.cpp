#include "report/frame_origins.hpp"

#include <algorithm>

namespace lippmann {
namespace {

/// Returns whether the render copied unchanged pixels. Reports of older versions call this mode `exact`.
bool is_copied(const RenderFigures& render) { return render.reuse == "copy" || render.reuse == "exact"; }

/// Returns the fractions of pixels by origin for a frame that was not fully traced. Pixels that are neither reused nor traced
/// count as filled.
OriginShares in_between_origins(const FrameReport& frame, double pixels, bool copied) {
  const double reused = std::min(static_cast<double>(frame.reused_pixels) / pixels, 1.0);
  if (copied) return {1.0 - reused, reused, 0.0, 0.0};
  const double traced = std::min(static_cast<double>(frame.retraced_pixels) / pixels, 1.0 - reused);
  return {traced, 0.0, reused, 1.0 - reused - traced};
}

}  // namespace

bool is_traced_whole(const FrameReport& frame) { return frame.kind == "full" || frame.kind == "key"; }

std::optional<OriginShares> origins_of(const FrameReport& frame, const RenderFigures& render) {
  if (frame.kind != "in-between") return OriginShares{1.0, 0.0, 0.0, 0.0};
  if (!render.pixels || *render.pixels < 1.0) return std::nullopt;
  return in_between_origins(frame, *render.pixels, is_copied(render));
}

std::optional<double> traced_cpu_seconds(const RenderFigures& render) {
  double seconds = 0.0;
  int count = 0;
  for (const FrameReport& frame : render.frames)
    if (is_traced_whole(frame)) seconds += frame.cpu_seconds, ++count;
  return count > 0 ? std::optional(seconds / count) : std::nullopt;
}

std::optional<double> saving(double seconds, std::optional<double> traced_seconds) {
  if (seconds <= 0.0 || !traced_seconds || *traced_seconds <= 0.0) return std::nullopt;
  return 1.0 - seconds / *traced_seconds;
}

}  // namespace lippmann

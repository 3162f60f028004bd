// Estimates the memory of a render's frames. If memory is short, plans to hold one frame at a time, or to render frames
// in bands of rows. Without the scene, the estimate differs from the measured memory by less than a factor of 1.5
// (docs/lab/decisions/0079-memory-is-estimated-by-part.md).
#pragma once

#include <string>

#include "folder/frame_layout.hpp"
#include "frames/frame.hpp"
#include "job/params.hpp"

namespace lippmann {

struct MemoryFacts {
  const RenderParams& params;
  FrameParams frame_settings;
  const FrameLayout& layout;
  Vec2i film{0, 0};
  int frames = 1;
  int frames_at_a_time = 1;    ///< frames in memory that are being traced, queued or written
  bool writes_videos = false;  ///< videos are written along with the frames
  /// Highest number of bands per frame; 1 if frames cannot be rendered in bands.
  int most_bands = 1;
  int rows_around = 0;  ///< extra rows traced above and below a band (frames/traced_frames.hpp)
};

struct MemoryPlan {
  int bands = 1;               ///< bands of rows per frame, which are traced one after another
  bool one_at_a_time = false;  ///< each frame is written before the next frame is traced
  double bytes = 0.0;          ///< estimated memory, for which at most two frames are counted
};

/// Estimated memory of `frames_at_a_time` frames, each traced in `bands` bands.
double estimated_bytes(const MemoryFacts& facts, int frames_at_a_time, int bands);

double joined_frame_bytes(const MemoryFacts& facts);

/// Returns the first plan that fits into `available` bytes with a reserve: the usual number of frames at a time, one
/// frame at a time, or one frame at a time in bands. Throws Error if no plan fits, which states why frames cannot be
/// traced in bands.
MemoryPlan plan_memory(const MemoryFacts& facts, double available);

/// Plans the memory of frames in strips (RenderParams::strips), each with its own file. `joins`: the run joins frames
/// from their strips.
MemoryPlan plan_strips_memory(const MemoryFacts& facts, int strips, bool joins, double available);

/// Describes the plan in a sentence; empty if the plan uses no measures against short memory.
std::string sentence_of(const MemoryPlan& plan, const MemoryFacts& facts, double available);

}  // namespace lippmann

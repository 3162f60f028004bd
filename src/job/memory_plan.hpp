// Estimates the memory of a render's frames. If memory is short, plans to hold one frame at a time, or to render frames in
// bands of rows.
//
// The estimate and the measured memory (without the memory of the scene) differ by less than a factor of 1.5.
// docs/lab/decisions/0079-memory-is-estimated-by-part.md has the figures.
#pragma once

#include <string>

#include "folder/frame_layout.hpp"
#include "frames/frame.hpp"
#include "job/params.hpp"

namespace lippmann {

/// The facts that determine the memory of a render, besides the number of pixels.
struct MemoryFacts {
  const RenderParams& params;
  FrameParams frame_settings;
  const FrameLayout& layout;
  Vec2i film{0, 0};
  int frames = 1;
  int frames_at_a_time = 1;    ///< maximum number of frames in memory that are being traced, queued or written
  bool writes_videos = false;  ///< whether videos are written along with the frames
  /// Maximum number of bands per frame. 1 if frames cannot be rendered in bands.
  int most_bands = 1;
  int rows_around = 0;  ///< number of extra rows traced above and below a band (frames/traced_frames.hpp)
};

/// How frames are rendered so that they fit into memory.
struct MemoryPlan {
  int bands = 1;               ///< number of bands of rows per frame, which are traced one after another
  bool one_at_a_time = false;  ///< whether each frame is written before the next frame is traced
  double bytes = 0.0;          ///< estimated memory in bytes, if at most two frames are in memory
};

/// Returns the estimated bytes of `frames_at_a_time` frames, each traced in `bands` bands.
double estimated_bytes(const MemoryFacts& facts, int frames_at_a_time, int bands);

double joined_frame_bytes(const MemoryFacts& facts);

/// Returns the first of the following plans that fits into `available` bytes with a reserve. Throws Error if no plan fits. If
/// frames cannot be traced in bands, the error states why.
/// 1. the usual number of frames at a time
/// 2. one frame at a time
/// 3. one frame at a time, in bands
MemoryPlan plan_memory(const MemoryFacts& facts, double available);

/// Plans the memory of frames that are rendered in strips (RenderParams::strips). Each strip has its own file. `joins` states
/// whether the run joins frames from their strips.
MemoryPlan plan_strips_memory(const MemoryFacts& facts, int strips, bool joins, double available);

/// Returns a sentence that describes the plan. Returns an empty string for the usual plan.
std::string sentence_of(const MemoryPlan& plan, const MemoryFacts& facts, double available);

}  // namespace lippmann

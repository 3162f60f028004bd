// Estimates the memory of a render's frames. If memory is short, plans to render one frame at a time, or frames in bands of
// rows.
//
// The estimate is within a factor of 1.5 of the measured memory beyond that of the scene
// (docs/lab/decisions/0079-memory-is-estimated-by-part.md has the figures).
#pragma once

#include <string>

#include "folder/frame_layout.hpp"
#include "frames/frame.hpp"
#include "job/params.hpp"

namespace lippmann {

/// Inputs of the memory estimate, besides the pixels.
struct MemoryFacts {
  const RenderParams& params;
  FrameParams frame_settings;
  const FrameLayout& layout;
  Vec2i film{0, 0};
  int frames = 1;              ///< number of frames to render
  int frames_at_a_time = 1;    ///< maximum number of frames being traced, queued and written
  bool writes_videos = false;  ///< along with the frames
  int most_bands = 1;          ///< maximum number of bands per frame; 1: frames cannot be cut
  int rows_around = 0;         ///< extra rows traced above and below a band (frames/traced_frames.hpp)
};

/// How frames are made.
struct MemoryPlan {
  int bands = 1;               ///< bands of rows per frame, traced separately
  bool one_at_a_time = false;  ///< each frame is written before the next one is traced
  double bytes = 0.0;          ///< the estimate, for up to two frames at a time
};

/// Estimates the bytes for a number of frames at a time, each in `bands` bands.
double estimated_bytes(const MemoryFacts& facts, int frames_at_a_time, int bands);

/// Estimates the bytes for joining a frame from the files of its strips.
double joined_frame_bytes(const MemoryFacts& facts);

/// Returns the first plan that fits into `available` bytes with a reserve: the usual number of frames at a time, one frame at a
/// time, bands. Throws Error if none fits, with the reason why bands do not help.
MemoryPlan plan_memory(const MemoryFacts& facts, double available);

/// Plans frames that are rendered in strips (RenderParams::strips), each with its own file. joins: frames are joined from them.
MemoryPlan plan_strips_memory(const MemoryFacts& facts, int strips, bool joins, double available);

/// Describes the plan in one sentence; empty for the usual plan.
std::string sentence_of(const MemoryPlan& plan, const MemoryFacts& facts, double available);

}  // namespace lippmann

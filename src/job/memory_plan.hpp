// Estimates the memory of a render's frames. If memory is short, plans to render one frame at a time, or frames in bands of
// rows.
//
// The estimate, and the measured memory beyond that of the scene, differ by less than a factor of 1.5
// (docs/lab/decisions/0079-memory-is-estimated-by-part.md has the figures).
#pragma once

#include <string>

#include "folder/frame_layout.hpp"
#include "frames/frame.hpp"
#include "job/params.hpp"

namespace lippmann {

/// Facts that the memory estimate depends on, besides the number of pixels.
struct MemoryFacts {
  const RenderParams& params;
  FrameParams frame_settings;
  const FrameLayout& layout;
  Vec2i film{0, 0};
  int frames = 1;              ///< number of frames to render
  int frames_at_a_time = 1;    ///< maximum number of frames in memory at once, being traced, queued or written
  bool writes_videos = false;  ///< whether videos are written along with the frames
  int most_bands = 1;          ///< maximum number of bands per frame; 1: frames cannot be rendered in bands
  int rows_around = 0;         ///< extra rows traced above and below a band (frames/traced_frames.hpp)
};

/// How frames are made so that they fit into memory.
struct MemoryPlan {
  int bands = 1;               ///< bands of rows per frame, traced separately
  bool one_at_a_time = false;  ///< whether each frame is written before the next one is traced
  double bytes = 0.0;          ///< estimated memory, for up to two frames at a time
};

/// Estimates the bytes needed for a number of frames in memory at once, each traced in `bands` bands.
double estimated_bytes(const MemoryFacts& facts, int frames_at_a_time, int bands);

/// Estimates the bytes needed to join a frame from the files of its strips.
double joined_frame_bytes(const MemoryFacts& facts);

/// Returns the first of these plans that fits into `available` bytes with a reserve: the usual number of frames at a time; one
/// frame at a time; one frame at a time in bands. Throws Error if none fits, with the reason why bands do not help.
MemoryPlan plan_memory(const MemoryFacts& facts, double available);

/// Plans frames that are rendered in strips (RenderParams::strips), each with its own file. joins: whether frames are then
/// joined from their strips.
MemoryPlan plan_strips_memory(const MemoryFacts& facts, int strips, bool joins, double available);

/// Describes the plan in one sentence; empty for the usual plan.
std::string sentence_of(const MemoryPlan& plan, const MemoryFacts& facts, double available);

}  // namespace lippmann

// How much memory the frames of a render take, and how they are made where memory is short: one at a time, then in bands of
// rows.
//
// An estimate, within a factor of 1.5 of what renders have been measured to take beyond what the scene takes
// (docs/lab/decisions/0079-memory-is-estimated-by-part.md has the figures).
#pragma once

#include <string>

#include "folder/frame_layout.hpp"
#include "frames/frame.hpp"
#include "job/params.hpp"

namespace lippmann {

/// The inputs of the memory estimate, beside the pixels.
struct MemoryFacts {
  const RenderParams& params;
  FrameParams made_as;
  const FrameLayout& layout;
  Vec2i film{0, 0};
  int frames = 1;              ///< that are rendered
  int frames_at_a_time = 1;    ///< at most: being traced, waiting and being written
  bool writes_videos = false;  ///< along with the frames
  int most_bands = 1;          ///< into which a frame can be cut; 1: it cannot
  int rows_around = 0;         ///< of a band, above it and below it, that are traced with it (frames/traced_frames.hpp)
};

/// How frames are made.
struct MemoryPlan {
  int bands = 1;               ///< of rows, each traced by itself
  bool one_at_a_time = false;  ///< a frame is written before the next one is traced
  double bytes = 0.0;          ///< the estimate, for two frames at a time where there are as many
};

/// Bytes of so many frames at a time in so many bands.
double estimated_bytes(const MemoryFacts& facts, int frames_at_a_time, int bands);

/// Memory for joining a frame from the files of its strips.
double joined_frame_bytes(const MemoryFacts& facts);

/// The first that fits, with a reserve, into `available` bytes: as many frames at a time as usual, one, bands. Throws Error
/// where nothing does, with the reason why bands do not help.
MemoryPlan plan_memory(const MemoryFacts& facts, double available);

/// The same for frames that a job wants in strips (RenderParams::strips), which have files; joins: frames are joined from them.
MemoryPlan plan_strips_memory(const MemoryFacts& facts, int strips, bool joins, double available);

/// One sentence for people; empty where all is as usual.
std::string sentence_of(const MemoryPlan& plan, const MemoryFacts& facts, double available);

}  // namespace lippmann

// The videos of a job: their files, their encoding and their preconditions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "folder/frame_layout.hpp"
#include "folder/frame_sink.hpp"
#include "folder/render_folder.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Throws a usage Error if no video can be made of the job's pictures. `is_shared`: other processes render some of the
/// frames.
void check_videos(const OutputParams& output, const FrameLayout& layout, bool is_shared);

std::vector<VideoFile> job_videos(const ResolvedJob& job, const FrameLayout& layout, double frames_per_second);

std::vector<std::string> names_of(const std::vector<VideoFile>& videos);

/// Makes the folders of the videos and removes files left by a killed run. Warns if a video exceeds the limits of
/// `display`, which may be null. Throws Error if a video cannot be written.
void make_room_for_videos(const std::vector<VideoFile>& videos, const FrameLayout& layout, const Display* display,
                          const Context& context);

/// Completes the videos of `frames`, which `sink` must have received, and records them in the folder's journal. Videos
/// of a kSingleFolder (single_clip.hpp) are also recorded in the journal of the light field's folder.
void finish_videos(const std::vector<VideoFile>& videos, const std::vector<int>& frames, FrameSink& sink, RenderFolder& folder);

}  // namespace lippmann

// The videos of a job: their files, their encoding, and their preconditions.
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

/// Throws a usage Error if videos cannot be made of the job's pictures. is_shared: other processes render some of the frames.
void check_videos(const OutputParams& output, const FrameLayout& layout, bool is_shared);

/// Returns the videos requested by the job.
std::vector<VideoFile> job_videos(const ResolvedJob& job, const FrameLayout& layout, double frames_per_second);

/// Returns the file names of the videos.
std::vector<std::string> names_of(const std::vector<VideoFile>& videos);

/// Makes the folders of videos and removes files left by a killed run. Warns of limits of `display` (may be null) that a video
/// exceeds. Throws Error for a video that cannot be written.
void make_room_for_videos(const std::vector<VideoFile>& videos, const FrameLayout& layout, const Display* display,
                          const Context& context);

/// Completes the videos of these frames, all of which `sink` has received. Records the videos in the folder's journal and, if
/// the folder is a companion (kSingleFolder), in the journal of the light field's folder too.
void finish_videos(const std::vector<VideoFile>& videos, const std::vector<int>& frames, FrameSink& sink, RenderFolder& folder);

}  // namespace lippmann

// The videos of a job: which files, how they are encoded, and what has to be there before they are begun.
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

/// Throws a usage Error where the job asks for videos of pictures that none can be made of. is_shared: other processes render
/// some of the frames.
void check_videos(const OutputParams& output, const FrameLayout& layout, bool is_shared);

/// The videos that the job asks for.
std::vector<VideoFile> job_videos(const ResolvedJob& job, const FrameLayout& layout, double frames_per_second);

/// As they are named on disk.
std::vector<std::string> names_of(const std::vector<VideoFile>& videos);

/// Makes the folders of videos and clears away what a killed run has left of them. Warns of what `display`, if there is one,
/// does not play. Throws Error for one that cannot be written.
void make_room_for_videos(const std::vector<VideoFile>& videos, const FrameLayout& layout, const Display* display,
                          const Context& context);

/// Completes the videos of these frames, which `sink` has all been given, and records them in the folder's journal and in that
/// of the light field which it is a part of (kSingleFolder).
void finish_videos(const std::vector<VideoFile>& videos, const std::vector<int>& frames, FrameSink& sink, RenderFolder& folder);

}  // namespace lippmann

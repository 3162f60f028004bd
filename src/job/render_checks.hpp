// Checks before a render with videos.
#pragma once

#include <filesystem>

#include "folder/frame_layout.hpp"
#include "folder/frame_sink.hpp"
#include "job/params.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Warns of what the display that is rendered for will not play.
void warn_of_videos(const Display& display, const FrameLayout& layout, const Context& context);

/// How a video of this render is to be encoded.
VideoOptions video_options(const RenderParams& params, const std::filesystem::path& video, double frames_per_second);

/// Makes its folder and clears away what a killed run has left of it. Throws Error if it cannot be written.
void make_room_for_video(const VideoFile& video, Vec2i film);

}  // namespace lippmann

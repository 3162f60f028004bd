// What is looked at before hours are spent on a render: its memory, and its videos.
#pragma once

#include <filesystem>

#include "folder/frame_layout.hpp"
#include "folder/frame_sink.hpp"
#include "job/params.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Throws Error for frames that the machine's memory does not hold.
void require_memory(const RenderParams& params, double bytes_kept_per_pixel, const Optics& optics, bool moves_pixels,
                    int frames_at_a_time);

/// What one frame takes while it is written: film, layers, codes, and other places for pixels that the layout moves.
double frame_bytes(const RenderParams& params, const Optics& optics, bool moves_pixels);

/// Throws Error for strips (RenderParams::strips) that the machine's memory does not hold.
void require_memory_for_strips(const RenderParams& params, double bytes_kept_per_pixel, const Optics& optics);

/// Warns of what the display that is rendered for will not play.
void warn_of_videos(const Display& display, const FrameLayout& layout, const Context& context);

/// How a video of this render is to be encoded.
VideoOptions video_options(const RenderParams& params, const std::filesystem::path& video, double frames_per_second);

/// Makes its folder and clears away what a killed run has left of it. Throws Error if it cannot be written.
void make_room_for_video(const VideoFile& video, Vec2i film);

}  // namespace lippmann

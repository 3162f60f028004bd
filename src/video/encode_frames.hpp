// Makes a video of finished frames: pictures in a folder, numbered in their names.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "video/video_writer.hpp"

namespace lippmann {

struct NumberedFrame {
  int number = 0;
  std::filesystem::path path;
};

/// The frames that `from` names, none of them missing: a folder (of frame_0000.png, ..., or of whatever one series of
/// numbered pictures it holds, quilts' names included), or a pattern for the name of files, in which * or %04d stands for the
/// number. `wanted`: only these, in this order; empty: all from the lowest to the highest number.
/// Throws Error naming the folder and the first frame that is missing.
std::vector<NumberedFrame> find_frames(const std::string& from, std::vector<int> wanted = {});

/// `out` with the quilt's name that the frames have, unless it says one itself: room.mp4 of frame_0000_qs8x6a0.75.png, ...
/// becomes room_qs8x6a0.75.mp4. The same of stereo pictures, room_2x1.mp4, and of RGB-D, room_rgbd.mp4.
std::filesystem::path video_path(const std::filesystem::path& out, const std::vector<NumberedFrame>& frames);

/// How the views of two eyes lie in the frames, by their names; none: they are no stereo pictures.
std::optional<StereoLayout> stereo_of(const std::vector<NumberedFrame>& frames);

/// Writes the side file of a video of RGB-D frames, the one that all of them have; warns where they have none, or differ. Does
/// nothing for other frames.
void describe_depth_of(const std::vector<NumberedFrame>& frames, const std::filesystem::path& out, const Context& context);

/// Frames are read ahead on other threads, and turned clockwise by turn_deg: 0, 90, 180 or 270. `encoded` is called after each,
/// on one of them. Stops when the context is cancelled;
/// the file then is not written, and false returned. Throws Error as VideoWriter and read_image8 do.
bool encode_frames(const std::vector<NumberedFrame>& frames, const std::filesystem::path& out, const VideoOptions& options,
                   const Context& context, const std::function<void(const NumberedFrame&)>& encoded = {}, int turn_deg = 0);

}  // namespace lippmann

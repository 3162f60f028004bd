// Makes a video from finished frames: numbered image files in a folder.
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

/// Finds frames. `from` is one of:
/// - a folder that contains frame_0000.png, frame_0001.png, ...
/// - a folder that contains a single series of numbered images, including quilts
/// - a data set of cameras, whose pictures are in its folder images/
/// - a file name pattern, in which * or %04d stands for the frame number
/// `wanted` lists the frame numbers; empty means all from the lowest to the highest. Throws Error naming the folder and the
/// first missing frame.
std::vector<NumberedFrame> find_frames(const std::string& from, std::vector<int> wanted = {});

/// Returns `out` with the suffix that states the layout of the frames: room.mp4 becomes room_qs8x6a0.75.mp4 (quilts),
/// room_2x1.mp4 (stereo) or room_rgbd.mp4 (RGB-D).
std::filesystem::path video_path(const std::filesystem::path& out, const std::vector<NumberedFrame>& frames);

std::optional<StereoLayout> stereo_of(const std::vector<NumberedFrame>& frames);

/// Copies the side file of RGB-D frames, which states their depth range, for the video `out`. If a side file is missing or the
/// side files differ, warns and copies nothing.
void describe_depth_of(const std::vector<NumberedFrame>& frames, const std::filesystem::path& out, const Context& context);

/// Reads the frames on background threads and rotates them clockwise by `turn_deg` (0, 90, 180 or 270). Calls `encoded` on a
/// background thread after each frame. If the context is cancelled, returns false and writes no file. Throws Error as
/// VideoWriter and read_image8() do.
bool encode_frames(const std::vector<NumberedFrame>& frames, const std::filesystem::path& out, const VideoOptions& options,
                   const Context& context, const std::function<void(const NumberedFrame&)>& encoded = {}, int turn_deg = 0);

}  // namespace lippmann

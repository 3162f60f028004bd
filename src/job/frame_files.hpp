// The files of one frame: names, and writing the pictures with their extra layers.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/exr.hpp"
#include "job/params.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/image/encoding.hpp"

namespace lippmann {

/// What the files of a render's frames are called.
struct FrameNames {
  PictureFormat format = PictureFormat::kPng;
  std::string quilt = {};  ///< the end of a quilt's name, such as _qs8x6a0.75 (layout/quilt_name.hpp); else empty
  int views = 0;           ///< above 0: every frame is a folder of so many pictures
};

/// frame_0000.png, .tif or .exr; frame_0000_qs8x6a0.75.png; of views the folder frame_0000.
std::string frame_name(const FrameNames& names, int frame);

/// DIR/frame_0000.png, or DIR/frame_0000/view_000.png and so on.
std::vector<std::filesystem::path> picture_paths(const std::filesystem::path& folder, const FrameNames& names, int frame);

/// Writes what `params` asks for, each file whole or not at all. Views lie one below the other in `pictures`. Extra layers go
/// into EXR pictures, else into aov_0000.exr beside the picture (aov_000.exr beside a view).
/// `pixels_per_mm`: said by TIFF files; 0: nothing to say. `about`: attributes of EXR files. Returns what it wrote. Throws
/// Error naming the file.
std::vector<std::filesystem::path> write_frame_files(const std::filesystem::path& folder, const FrameNames& names, int frame,
                                                     const RenderParams& params, Encoding encoding, double pixels_per_mm,
                                                     const FramePictures& pictures, std::span<const ExrAttribute> about = {});

}  // namespace lippmann

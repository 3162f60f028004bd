// Writes the pictures of one frame with their extra layers.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "folder/picture_params.hpp"
#include "image/exr.hpp"
#include "layout/frame_names.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

/// Frames that are the views of one data set, each from a camera of its own.
struct OneSet {
  int count = 1;              ///< of all frames
  double units_per_mm = 1.0;  ///< world units per millimetre of the display frame
};

/// What all frames of a render have in common.
struct FrameFiles {
  std::filesystem::path folder;
  FrameNames names;
  PictureFormat format = PictureFormat::kPng;
  ExrPixels exr_pixels = ExrPixels::kHalf;
  Encoding encoding = Encoding::kSrgb;
  double pixels_per_mm = 0.0;            ///< stated by TIFF files; 0: not known
  std::vector<ExrAttribute> about = {};  ///< attributes of EXR files
  FormatOptions writing = {};            ///< what the formats of light fields are told
  std::optional<OneSet> one_set = {};    ///< none: every frame is a light field of its own
};

/// "png", "tif" or "exr".
const char* ending_of(PictureFormat format);

/// Each file whole or not at all. Where names.views > 0, the views lie one below the other in `pictures`. Extra layers go into
/// EXR pictures, else into a file beside them (layers_path). Returns what it wrote. Throws Error naming the file.
std::vector<std::filesystem::path> write_frame_files(const FrameFiles& files, int frame, const FramePictures& pictures);

/// The same of the views of a film as a format of light fields has them: a folder, or a picture. `pictures` holds codes, but
/// for EXR, and depth where the format uses it (Aov::kDepth).
std::vector<std::filesystem::path> write_light_field_files(const FrameFiles& files, int frame, const LightFieldFormat& format,
                                                           const Optics& optics, const FramePictures& pictures);

}  // namespace lippmann

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "folder/picture_params.hpp"
#include "formats/frame_names.hpp"
#include "image/exr.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/image/encoding.hpp"

namespace lippmann {

/// The frames of a render form a single data set, with one camera per frame.
struct OneSet {
  int count = 1;
  double units_per_mm = 1.0;  ///< world units per millimetre of the display frame
};

struct FrameFiles {
  std::filesystem::path folder;
  FrameNames names;
  PictureFormat format = PictureFormat::kPng;
  ExrPixels exr_pixels = ExrPixels::kHalf;
  Encoding encoding = Encoding::kSrgb;
  double pixels_per_mm = 0.0;  ///< resolution written to TIFF files; 0 if unknown
  std::vector<ExrAttribute> about = {};
  FormatOptions writing = {};
  /// nullopt: every frame is a light field of its own.
  std::optional<OneSet> one_set = {};
};

/// Returns "png", "tif" or "exr".
const char* ending_of(PictureFormat format);

/// Writes the pictures and layers of a frame. Each file appears atomically. If names.views > 0, `pictures` holds views that are
/// stacked vertically. EXR pictures include the extra layers; other pictures have a separate file for them (layers_path()).
/// Returns the paths of the written files. Throws Error that names the file.
std::vector<std::filesystem::path> write_frame_files(const FrameFiles& files, int frame, const FramePictures& pictures);

/// Writes the views of a film in a light-field format, as a folder or as one picture. `pictures` holds 8- or 16-bit
/// samples, or linear floats for EXR, and depth (Aov::kDepth) if the format uses it. Returns the paths of the written
/// files.
std::vector<std::filesystem::path> write_light_field_files(const FrameFiles& files, int frame, const LightFieldFormat& format,
                                                           const Optics& optics, const FramePictures& pictures);

}  // namespace lippmann

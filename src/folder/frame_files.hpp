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

/// Data for a render whose frames are the views of one data set, with one camera per frame.
struct OneSet {
  int count = 1;              ///< number of frames
  double units_per_mm = 1.0;  ///< world units per millimetre of the display frame
};

/// Settings shared by all frames of a render.
struct FrameFiles {
  std::filesystem::path folder;
  FrameNames names;
  PictureFormat format = PictureFormat::kPng;
  ExrPixels exr_pixels = ExrPixels::kHalf;
  Encoding encoding = Encoding::kSrgb;
  double pixels_per_mm = 0.0;            ///< resolution written to TIFF files; 0: unknown
  std::vector<ExrAttribute> about = {};  ///< attributes of EXR files
  FormatOptions writing = {};            ///< options of the light-field formats
  std::optional<OneSet> one_set = {};    ///< nullopt: every frame is a separate light field
};

/// Returns the file name extension "png", "tif" or "exr".
const char* ending_of(PictureFormat format);

/// Writes the files of a frame, each of them atomically. If names.views > 0, the views are stacked vertically in `pictures`.
/// Extra layers go into EXR pictures, else into a separate file (layers_path). Returns the files written. Throws Error naming
/// the file.
std::vector<std::filesystem::path> write_frame_files(const FrameFiles& files, int frame, const FramePictures& pictures);

/// Writes the views of a film in a light-field format, as a folder or as one picture. `pictures` holds codes (linear values for
/// EXR), and depth if the format uses it (Aov::kDepth).
std::vector<std::filesystem::path> write_light_field_files(const FrameFiles& files, int frame, const LightFieldFormat& format,
                                                           const Optics& optics, const FramePictures& pictures);

}  // namespace lippmann

// Detects the light field format of a picture or a folder from flags, names and a report.json beside it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "formats/rendered.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {

/// A light field that can be read by format->read(path, options).
struct LightFieldSource {
  const LightFieldFormat* format = nullptr;
  FormatOptions options;  ///< the given options, with missing ones added from the files beside the picture
  /// None: there is no report.json beside the picture, or the format ignores it.
  std::optional<Rendering> rendering = {};
  /// Views of `rendering`; none if its lenses are not a whole number of pixels wide.
  std::optional<RenderedViews> rendered = {};
};

/// `from`: a format's name; empty: detected from names and the report. Given options override the report. Throws Error
/// naming the file, or the flag that must be given because no file states its value.
LightFieldSource light_field_source(const std::filesystem::path& path, const std::string& from, const FormatOptions& options);

/// Returns the format that a picture's name or its side file implies; none if neither does. Throws Error for a
/// malformed side file or name.
std::optional<std::string> format_by_name(const std::filesystem::path& picture);

/// Returns whether the name is that of an HDF5 file or a Lytro container, which hold light fields but are not pictures.
bool is_light_field_file_name(const std::filesystem::path& file);

/// Returns a usage Error with the message that the format of this picture must be given.
Error unknown_format(const std::filesystem::path& picture);

/// Returns the format of `in`, or of its first frame. Throws Error as light_field_source() does.
const LightFieldFormat& format_of_light_field(const std::filesystem::path& in, const std::string& from);

/// Returns whether the folder holds files named like the views of a format, or holds only pictures. The pictures are then
/// taken as views.
bool is_light_field_folder(const std::filesystem::path& folder);

/// Returns the subfolder images/ if the folder has one and holds cameras of any pose (nerf, colmap, llff), otherwise
/// `folder` itself.
std::filesystem::path folder_of_pictures(const std::filesystem::path& folder);

/// Returns the frames of an animation in a folder; empty if the folder holds one light field, or nothing. The frames are the
/// first of these that exist:
/// 1. the folders frame_*, if `from` is a folder format (the other rules then do not apply);
/// 2. the pictures frame_*;
/// 3. the folders frame_*, if `from` is empty;
/// 4. unless the folder is a light field: the pictures of the format `from`, or, if `from` is empty, all pictures whose
///    names or side files imply a format.
std::vector<std::filesystem::path> light_field_frames(const std::filesystem::path& folder, const std::string& from);

}  // namespace lippmann

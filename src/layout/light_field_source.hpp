// What a picture or a folder is, among the formats of light fields: as flags, names and a report.json beside it say.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "layout/cameras.hpp"
#include "layout/rendered.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

/// A light field that can be read: source.format->read(path, source.options).
struct LightFieldSource {
  const LightFieldFormat* format = nullptr;
  FormatOptions options;                       ///< those that were given, completed by what lies beside the picture
  std::optional<Rendering> rendering = {};     ///< what a report.json beside it says; none where the format has no use for one
  std::optional<RenderedViews> rendered = {};  ///< its views; none where its lenses have no whole pixels
};

/// `from`: the name of a format; empty: as names and the report say. Options that are given win over the report. Throws Error
/// naming the file, or the flag that has to say what nothing else says.
LightFieldSource light_field_source(const std::filesystem::path& path, const std::string& from, const FormatOptions& options);

/// The format that the name of a picture or the side file beside it states; none: neither does. Throws Error for a side file or
/// a name that is damaged.
std::optional<std::string> format_by_name(const std::filesystem::path& picture);

/// A usage Error: the format of this picture has to be given.
Error unknown_format(const std::filesystem::path& picture);

/// The format in which `in`, or the first frame in it, is read. Throws as light_field_source.
const LightFieldFormat& format_of_light_field(const std::filesystem::path& in, const std::string& from);

/// Whether a folder holds files of views of a format that is known by their names, or pictures alone, which are views then.
bool is_light_field_folder(const std::filesystem::path& folder);

/// The frames of an animation in a folder, frame_*: pictures, or folders where the format is a folder; with an empty `from`
/// pictures if there are any. Without such names: the pictures of that format; with an empty `from` all whose names or side
/// files state one. None: the folder holds one light field, or nothing.
std::vector<std::filesystem::path> light_field_frames(const std::filesystem::path& folder, const std::string& from);

}  // namespace lippmann

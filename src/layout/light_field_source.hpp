// Detects the light field format of a picture or a folder from flags, names and a report.json beside it.
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

/// A light field that is ready to be read: source.format->read(path, source.options).
struct LightFieldSource {
  const LightFieldFormat* format = nullptr;
  FormatOptions options;                       ///< the given options, completed from the files beside the picture
  std::optional<Rendering> rendering = {};     ///< from a report.json beside it; none if there is none or the format ignores it
  std::optional<RenderedViews> rendered = {};  ///< its views; none if its lenses do not have whole pixels
};

/// Detects the source. `from`: a format's name; empty: from names and the report. Given options override the report. Throws
/// Error naming the file, or the flag that is required because nothing else states its value.
LightFieldSource light_field_source(const std::filesystem::path& path, const std::string& from, const FormatOptions& options);

/// Returns the format implied by a picture's name or its side file; none if there is neither. Throws Error for a malformed side
/// file or name.
std::optional<std::string> format_by_name(const std::filesystem::path& picture);

/// Returns a usage Error that the format of this picture must be given.
Error unknown_format(const std::filesystem::path& picture);

/// Returns the format of `in`, or of its first frame. Throws like light_field_source().
const LightFieldFormat& format_of_light_field(const std::filesystem::path& in, const std::string& from);

/// Returns whether a folder holds view files of a format recognised by their names, or only pictures, which are then views.
bool is_light_field_folder(const std::filesystem::path& folder);

/// Returns the frames of an animation in a folder, frame_*: pictures, or folders if the format is a folder; with an empty
/// `from`, pictures if there are any. Without such names: the pictures of that format; with an empty `from`, all pictures whose
/// names or side files imply a format. Empty: the folder holds one light field, or nothing.
std::vector<std::filesystem::path> light_field_frames(const std::filesystem::path& folder, const std::string& from);

}  // namespace lippmann

// The side file of a folder of views, views.json. It states the shape of the pixels, which pictures do not state.
//
//   {"views": {"pixel_aspect": 8}}
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lippmann {

/// Reads width / height of the pixels from FOLDER/views.json; none if the file does not exist or describes something else.
/// Throws Error naming the file.
std::optional<double> read_pixel_aspect(const std::filesystem::path& folder);
/// Parses a side file; none for JSON without the key `views`. Throws Error naming `where`.
std::optional<double> parse_pixel_aspect(const std::string& text, const std::string& where);

/// Writes FOLDER/views.json and returns its path.
std::filesystem::path write_pixel_aspect(const std::filesystem::path& folder, double pixel_aspect);
/// Returns whether FOLDER/views.json exists.
bool has_views_side_file(const std::filesystem::path& folder);

}  // namespace lippmann

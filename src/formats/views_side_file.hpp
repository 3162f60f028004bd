// The side file of a folder of views, views.json. It states what pictures do not state.
//
//   {"views": {"columns": 9, "rows": 9, "pixel_aspect": 8, "positions": [...], "cameras": {...}}}
//
// All keys are optional. `pixel_aspect`: width / height of the pixels. `positions` and `cameras` (formats/camera_json.hpp) need
// `columns` and `rows`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

struct ViewsSideFile {
  std::optional<ViewGrid> grid = {};
  std::optional<double> pixel_aspect = {};
  std::optional<std::vector<Vec2d>> positions = {};
  std::optional<ViewCameras> cameras = {};
};

/// Reads FOLDER/views.json; none if the file does not exist or describes something else. Throws Error naming the file.
std::optional<ViewsSideFile> read_views_side_file(const std::filesystem::path& folder);
/// Parses a side file; none for JSON without the key `views`. Throws Error naming `where`.
std::optional<ViewsSideFile> parse_views_side_file(const std::string& text, const std::string& where);
std::string views_side_text(const ViewsSideFile& side);

/// Writes FOLDER/views.json and returns its path.
std::filesystem::path write_views_side_file(const std::filesystem::path& folder, const ViewsSideFile& side);
/// Returns whether FOLDER/views.json exists.
bool has_views_side_file(const std::filesystem::path& folder);

}  // namespace lippmann

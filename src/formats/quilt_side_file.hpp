// Reads and writes the JSON side file of a quilt, <image>.json. It states the tiles and the aspect ratio, as the quilt's
// name does, and also the number and order of the views. A grid of views with several rows has the key "grid" beside
// "quilt_settings": {"columns": 5, "rows": 5}. Other programs ignore this key and see one row of views.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "lippmann/formats/quilt_name.hpp"

namespace lippmann {

struct QuiltSideFile {
  QuiltName quilt;
  /// Number of views, which fill the first tiles.
  int views = 0;
  bool inverted = false;              ///< true: the first view of each row is the rightmost
  std::optional<ViewGrid> grid = {};  ///< none: the views are one row
};

inline constexpr std::string_view kQuiltSideFileExample = R"({"quilt_settings": {"viewX": 8, "viewY": 6, "aspect": 0.75}})";

std::filesystem::path quilt_side_path(const std::filesystem::path& image);

/// Reads the side file of an image. Returns none if it does not exist or does not describe a quilt. The table is
/// "quilt_settings", "quilt" or the document itself. Its keys are viewX and viewY, columns and rows, or quiltCols and
/// quiltRows. Throws Error for impossible values, and for a grid with another number of views.
std::optional<QuiltSideFile> read_quilt_side_file(const std::filesystem::path& image);

/// `where`: name of the file, for messages.
std::optional<QuiltSideFile> parse_quilt_side_file(const std::string& text, const std::string& where);

void write_quilt_side_file(const std::filesystem::path& image, const QuiltSideFile& side);

}  // namespace lippmann

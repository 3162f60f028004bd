// The JSON file beside a quilt, <image>.json, that says what its name says and a little more.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "lippmann/layout/quilt_name.hpp"

namespace lippmann {

struct QuiltSideFile {
  QuiltName quilt;
  int views = 0;          ///< in the first tiles; not more than there are tiles
  bool inverted = false;  ///< view 0 is the rightmost
};

inline constexpr std::string_view kQuiltSideFileExample = R"({"quilt_settings": {"viewX": 8, "viewY": 6, "aspect": 0.75}})";

std::filesystem::path quilt_side_path(const std::filesystem::path& image);

/// Returns nothing if there is no such file or it does not describe a quilt. In place of {"quilt_settings": {"viewX": 8,
/// "viewY": 6}} the table may be called quilt or be the document itself, and its keys columns and rows, or quiltCols and
/// quiltRows. Throws Error where it says something impossible.
std::optional<QuiltSideFile> read_quilt_side_file(const std::filesystem::path& image);

/// Reads its text; `where` names it in messages.
std::optional<QuiltSideFile> parse_quilt_side_file(const std::string& text, const std::string& where);

void write_quilt_side_file(const std::filesystem::path& image, const QuiltSideFile& side);

}  // namespace lippmann

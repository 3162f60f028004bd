// The JSON side file of a quilt, <image>.json, which states the same as its name and more.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "lippmann/layout/quilt_name.hpp"

namespace lippmann {

struct QuiltSideFile {
  QuiltName quilt;
  int views = 0;          ///< number of views, in the first tiles; at most the number of tiles
  bool inverted = false;  ///< view 0 is the rightmost
};

inline constexpr std::string_view kQuiltSideFileExample = R"({"quilt_settings": {"viewX": 8, "viewY": 6, "aspect": 0.75}})";

std::filesystem::path quilt_side_path(const std::filesystem::path& image);

/// Reads the side file; none if it does not exist or does not describe a quilt. Instead of {"quilt_settings": {"viewX": 8,
/// "viewY": 6}}, the table may be named quilt or be the document itself, and its keys columns and rows, or quiltCols and
/// quiltRows. Throws Error for impossible values.
std::optional<QuiltSideFile> read_quilt_side_file(const std::filesystem::path& image);

/// Parses a side file; `where` names it in messages.
std::optional<QuiltSideFile> parse_quilt_side_file(const std::string& text, const std::string& where);

void write_quilt_side_file(const std::filesystem::path& image, const QuiltSideFile& side);

}  // namespace lippmann

// File names of quads, four views in one picture: name_2x2.png, as in Leia's programs. Letters may be upper or lower case. A
// suffix of copies, such as " (1)", is allowed (layout/copy_mark.hpp).
#pragma once

#include <filesystem>
#include <string_view>

namespace lippmann {

inline constexpr std::string_view kQuadFormat = "quad";
inline constexpr std::string_view kQuadEnding = "_2x2";

bool has_quad_name(const std::filesystem::path& path);
std::filesystem::path without_quad_name(const std::filesystem::path& path);
std::filesystem::path with_quad_name(const std::filesystem::path& path);

}  // namespace lippmann

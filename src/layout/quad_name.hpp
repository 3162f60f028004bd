// Quads, four views in one picture, are called name_2x2.png, as Leia's programs call them; letters of either case, and marks of
// copies (layout/copy_mark.hpp) may follow.
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

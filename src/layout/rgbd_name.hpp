// RGB-D pictures are called name_rgbd.png, name.rgbd.png or rgbd.png; letters of either case, and marks of copies
// (layout/copy_mark.hpp) may follow. name_hrgbd.png is a picture whose halves are squeezed to half their width.
#pragma once

#include <filesystem>
#include <string_view>

namespace lippmann {

inline constexpr std::string_view kRgbdFormat = "rgbd";
inline constexpr std::string_view kRgbdEnding = "_rgbd";

bool has_rgbd_name(const std::filesystem::path& path);
bool has_half_rgbd_name(const std::filesystem::path& path);
std::filesystem::path without_rgbd_name(const std::filesystem::path& path);
std::filesystem::path with_rgbd_name(const std::filesystem::path& path);

}  // namespace lippmann

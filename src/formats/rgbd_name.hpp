// File names of RGB-D pictures: name_rgbd.png, name.rgbd.png or rgbd.png. Letters may be upper or lower case. A suffix of
// copies, such as " (1)", is allowed (layout/copy_mark.hpp). A name such as name_hrgbd.png means that both halves are squeezed
// to half their width.
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

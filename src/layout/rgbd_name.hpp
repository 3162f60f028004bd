// RGB-D pictures are called name_rgbd.png.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lippmann {

inline constexpr std::string_view kRgbdFormat = "rgbd";
inline constexpr std::string_view kRgbdEnding = "_rgbd";

inline bool has_rgbd_name(const std::filesystem::path& path) { return path.stem().string().ends_with(kRgbdEnding); }

inline std::filesystem::path without_rgbd_name(const std::filesystem::path& path) {
  if (!has_rgbd_name(path)) return path;
  std::string stem = path.stem().string();
  stem.resize(stem.size() - kRgbdEnding.size());
  return path.parent_path() / (stem + path.extension().string());
}

inline std::filesystem::path with_rgbd_name(const std::filesystem::path& path) {
  if (has_rgbd_name(path)) return path;
  return path.parent_path() / (path.stem().string() + std::string(kRgbdEnding) + path.extension().string());
}

}  // namespace lippmann

#include "formats/frame_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string_view>

#include "core/folder_entries.hpp"
#include "core/recorded_file.hpp"
#include "core/text_pattern.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Matches the names of files of one frame, relative to the render's folder. Such a file may be
///   - a picture or layer named by its frame, beside those of other frames;
///   - in the folder images or depth of a data set in which every view is a frame;
///   - in the folder of its frame, for formats with several files (views, HCI, Stanford, JPEG Pleno, MIV, NeRF, COLMAP, LLFF,
///     cvkit, Lytro).
constexpr const char* kFrameFiles =
    R"((?:images/([0-9]{3,6})\.(?:png|exr)|depth/([0-9]{3,6})(?:_ray)?\.npy)|)"
    R"((?:frame|aov)_([0-9]{1,9})(?:_qs[0-9xa.e+-]+|_(?:half_)?(?:2x1|ou)(?:_rl)?|_rows(?:_rl)?|_2x2|_rgbd)?\.(?:png|tif|exr)(?:\.json)?)"
    R"(|frame_([0-9]{1,9})/(?:(?:view|aov)_[0-9]{1,9}\.(?:png|tif|exr)|parameters\.cfg|cameras\.json|input_Cam[0-9]{1,6}\.(?:png|exr))"
    R"(|gt_(?:depth|disp)_lowres(?:_Cam[0-9]{1,6})?\.pfm|out_[0-9]{1,5}_[0-9]{1,5}(?:_[0-9.+-]{1,40})*\.(?:png|exr))"
    R"(|[0-9]{1,4}_[0-9]{1,4}\.ppm|view_[0-9]{1,6}_(?:depth\.png|disp\.pfm|param\.txt)|SAI_[0-9]{1,4}_[0-9]{1,4}\.(?:png|exr))"
    R"(|images/[0-9]{3,6}\.(?:png|exr)|depth/[0-9]{3,6}(?:_ray)?\.npy|transforms\.json)"
    R"(|poses_bounds\.npy|sparse/0/(?:cameras|images|points3D)\.(?:txt|bin))|strip_([0-9]{1,9})_[0-9]{1,9}\.exr)";

std::vector<fs::path> frames_in(const fs::path& folder, bool are_folders) {
  require_recorded_frames(folder);
  std::vector<fs::path> frames;
  for (const fs::directory_entry& entry : entries_of(folder)) {
    const bool fits = entry.is_directory() ? are_folders : !are_folders && is_picture_name(entry.path());
    if (fits && entry.path().filename().string().starts_with("frame_")) frames.push_back(entry.path());
  }
  return frames;
}

}  // namespace

std::string frame_name(const FrameNames& names, int frame) {
  if (names.views > 0 || names.is_folder) return fmt::format("frame_{:04}", frame);
  return fmt::format("frame_{:04}{}.{}", frame, names.suffix, names.ending);
}

std::vector<fs::path> picture_paths(const fs::path& folder, const FrameNames& names, int frame) {
  const fs::path whole = folder / frame_name(names, frame);
  if (names.views == 0) return {whole};
  std::vector<fs::path> paths;
  for (int view = 0; view < names.views; ++view) paths.push_back(whole / fmt::format("view_{:03}.{}", view, names.ending));
  return paths;
}

fs::path layers_path(const fs::path& folder, int frame, int view) {
  if (view < 0) return folder / fmt::format("aov_{:04}.exr", frame);
  return folder / fmt::format("frame_{:04}", frame) / fmt::format("aov_{:03}.exr", view);
}

std::string strip_name(int frame, int strip) { return fmt::format("strip_{:04}_{:03}.exr", frame, strip); }

bool is_strip_name(const std::string& name) { return name.starts_with("strip_") && frame_of_file(name); }

std::optional<int> frame_of_file(const std::string& name) {
  constexpr std::size_t kMaxLetters = 255;
  if (name.size() > kMaxLetters) return std::nullopt;
  static const TextPattern pattern(kFrameFiles);
  const std::optional<PatternMatch> found = pattern.match(name);
  if (!found) return std::nullopt;
  // exactly one group contains digits
  const std::string digits = found->groups[1] + found->groups[2] + found->groups[3] + found->groups[4] + found->groups[5];
  int frame = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), frame);
  return frame;
}

bool is_picture_name(const fs::path& path) {
  constexpr std::array<std::string_view, 18> kEndings{".png", ".exr",  ".tif", ".tiff", ".jpg",  ".jpeg",
                                                      ".ppm", ".pgm",  ".pnm", ".tga",  ".bmp",  ".hdr",
                                                      ".pfm", ".webp", ".gif", ".heic", ".heif", ".avif"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

std::vector<fs::path> frame_pictures_in(const fs::path& folder) { return frames_in(folder, false); }

std::vector<fs::path> frame_folders_in(const fs::path& folder) { return frames_in(folder, true); }

}  // namespace lippmann

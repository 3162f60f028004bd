// LLFF's folders: images/000.png, ... and poses_bounds.npy (layout/llff_poses.hpp), which has one row per picture, in the order
// of the pictures' names. Depth bounds come from the depth of the views if it is known, otherwise from the file that was read.
#include <fmt/format.h>

#include <algorithm>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/folder_entries.hpp"
#include "core/recorded_file.hpp"
#include "layout/frame_names.hpp"
#include "layout/llff_poses.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

LightField read_llff(const fs::path& folder, const FormatOptions& options) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;
  const fs::path file = folder / "poses_bounds.npy", images = folder / "images";
  const std::string accepted = "a folder with images and poses_bounds.npy";
  std::vector<PosedPicture> pictures = parse_llff_poses(read_recorded_bytes(file, kMaxBytes, accepted), file.string());
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : entries_of(images, accepted))
    if (entry.is_regular_file() && is_picture_name(entry.path())) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());  // LLFF sorts names as text, so "10.png" comes before "2.png"
  if (names.size() != pictures.size())
    throw Error(file.string(),
                fmt::format("has {} rows, but {} has {} pictures", pictures.size(), images.string(), names.size()),
                "a row for each picture");
  for (std::size_t i = 0; i < names.size(); ++i) pictures[i].picture = names[i];
  read_held_out_names(folder / "test.txt", pictures);
  return read_posed_pictures(images, {file, std::move(pictures)}, options);
}

std::vector<Vec2d> bounds_of_views(const LightField& field) {
  if (field.depth_bounds_mm && !field.depth) return *field.depth_bounds_mm;
  return std::vector<Vec2d>(static_cast<std::size_t>(field.grid.count()), depth_bounds_mm(field));
}

std::vector<fs::path> write_llff(const LightField& field, const fs::path& folder, const FormatOptions&) {
  const std::vector<std::byte> poses =
      encode_llff_poses(posed_cameras(field, folder.string()), bounds_of_views(field), folder.string());
  std::vector<fs::path> written = write_posed_pictures(field, folder);
  if (field.splits) write_held_out_names(written.emplace_back(folder / "test.txt"), listed_pictures(field, folder));
  write_file_atomically(written.emplace_back(folder / "poses_bounds.npy"), poses);
  return written;
}

}  // namespace

LightFieldFormat llff_format() {
  return {.name = "llff",
          .description = "LLFF's folder: images/000.png, ... and poses_bounds.npy with their cameras",
          .is_folder = true,
          .uses_cameras = true,
          .keeps_poses = true,
          .keeps_depth_bounds = true,
          .keeps_splits = true,
          .states_cameras = true,
          .read = read_llff,
          .write = write_llff};
}

}  // namespace lippmann

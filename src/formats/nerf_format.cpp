// NeRF data sets: transforms.json (formats/transforms_json.hpp), images/000.png, ... If depth is known, depth/000.npy, ... hold
// planar depth, and depth/000_ray.npy, ... ray lengths. If the views are split into parts, transforms_train.json,
// transforms_val.json and transforms_test.json list the parts.
//
// Depth is in thousandths of the unit of the matrices, as expected by nerfstudio's default depth_unit_scale_factor.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "formats/picture_folder.hpp"
#include "formats/transforms_json.hpp"
#include "formats/view_files.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<const char*, Split> kSplitFiles[] = {{"transforms_train.json", Split::kTraining},
                                                         {"transforms_val.json", Split::kValidation},
                                                         {"transforms_test.json", Split::kTest}};

std::vector<PosedPicture> read_transforms(const fs::path& file, const FormatOptions& options) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;
  return parse_transforms(read_recorded_text(file, kMaxBytes, "a folder of pictures and transforms.json"), file.string(),
                          options.warn);
}

/// Reads transforms.json or, if it is missing, transforms_train.json and the files beside it for validation and testing.
PosedSet read_set(const fs::path& folder, const FormatOptions& options) {
  PosedSet set{folder / "transforms.json", {}};
  if (is_regular_file_there(set.file) || !is_regular_file_there(folder / kSplitFiles[0].first)) {
    set.pictures = read_transforms(set.file, options);
    return set;
  }
  set.file = folder / kSplitFiles[0].first;
  for (const auto& [name, split] : kSplitFiles) {
    if (!is_regular_file_there(folder / name)) continue;
    for (PosedPicture& picture : read_transforms(folder / name, options))
      set.pictures.emplace_back(std::move(picture)).split = split;
  }
  return set;
}

/// Warns about pictures beside those of the frames that are not in a frame, and about times that not all frames have.
void warn_of_lost_pictures(const fs::path& folder, const PosedSet& set, const FormatOptions& options) {
  std::set<fs::path> used, folders;
  for (const PosedPicture& picture : set.pictures) {
    const fs::path path = path_of_picture(folder, picture).lexically_normal();
    used.insert(path), folders.insert(path.parent_path());
    if (!picture.depth.empty()) used.insert((folder / picture.depth).lexically_normal());
  }
  const auto is_used = [&](const fs::path& path) { return used.contains(path.lexically_normal()); };
  for (const fs::path& pictures : folders)
    warn_of_pictures_without_camera(pictures, is_used, set.file.filename().string(), options.warn);
  const auto timed = std::ranges::count_if(set.pictures, [](const PosedPicture& p) { return p.time.has_value(); });
  if (timed > 0 && timed < std::ssize(set.pictures) && options.warn)
    options.warn(fmt::format("{}: the times are left out, because only {} of {} frames have one", set.file.string(), timed,
                             set.pictures.size()));
}

LightField read_nerf(const fs::path& folder, const FormatOptions& options) {
  PosedSet set = read_set(folder, options);
  warn_of_lost_pictures(folder, set, options);
  return read_posed_pictures(folder, std::move(set), options);
}

std::vector<fs::path> write_nerf(const LightField& field, const fs::path& folder, const FormatOptions&) {
  std::vector<PosedPicture> pictures = listed_pictures(field, folder);
  std::vector<fs::path> written = write_posed_pictures(field, folder);
  if (field.depth) make_folder(folder / "depth");
  for (int view = 0; field.depth && view < field.grid.count(); ++view) {
    PosedPicture& picture = pictures[static_cast<std::size_t>(view)];
    picture.depth = posed_depth_name(view, field.grid.count());
    for (fs::path& path : write_posed_depth(field, view, picture.camera, folder, picture.depth))
      written.push_back(std::move(path));
  }
  const auto write = [&](const char* name, const std::string& text) {
    write_file_atomically(written.emplace_back(folder / name), std::as_bytes(std::span(text)));
  };
  for (const auto& [name, split] : kSplitFiles)
    if (const std::string text = split_transforms_text(pictures, split); !text.empty()) write(name, text);
  write("transforms.json", transforms_text(pictures));
  return written;
}

}  // namespace

LightFieldFormat nerf_format() {
  return {
      .name = "nerf",
      .description = "NeRF's folder: images/000.png, ... and transforms.json with their cameras; planar depth and ray lengths",
      .is_folder = true,
      .states_cameras = true,
      .read = read_nerf,
      .write = write_nerf};
}

}  // namespace lippmann

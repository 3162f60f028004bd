// NeRF data sets: transforms.json (layout/transforms_json.hpp), images/000.png, ... If depth is known, depth/000.npy, ... hold
// planar depth, and depth/000_ray.npy, ... ray lengths. If the views are split into parts, transforms_train.json,
// transforms_val.json and transforms_test.json list the parts.
//
// Depth is in thousandths of the unit of the matrices, as expected by nerfstudio's default depth_unit_scale_factor.
#include <span>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "layout/transforms_json.hpp"
#include "layout/view_files.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<const char*, Split> kSplitFiles[] = {{"transforms_train.json", Split::kTraining},
                                                         {"transforms_val.json", Split::kValidation},
                                                         {"transforms_test.json", Split::kTest}};

std::vector<PosedPicture> read_transforms(const fs::path& file) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;
  return parse_transforms(read_recorded_text(file, kMaxBytes, "a folder of pictures and transforms.json"), file.string());
}

/// Reads transforms.json or, if it is missing, transforms_train.json and the files beside it for validation and testing.
PosedSet read_set(const fs::path& folder) {
  PosedSet set{folder / "transforms.json", {}};
  if (is_regular_file_there(set.file) || !is_regular_file_there(folder / kSplitFiles[0].first)) {
    set.pictures = read_transforms(set.file);
    return set;
  }
  set.file = folder / kSplitFiles[0].first;
  for (const auto& [name, split] : kSplitFiles) {
    if (!is_regular_file_there(folder / name)) continue;
    for (PosedPicture& picture : read_transforms(folder / name)) set.pictures.emplace_back(std::move(picture)).split = split;
  }
  return set;
}

LightField read_nerf(const fs::path& folder, const FormatOptions& options) {
  return read_posed_pictures(folder, read_set(folder), options);
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
  const auto write = [&](const char* name, const std::vector<PosedPicture>& listed) {
    const std::string text = transforms_text(listed);
    write_file_atomically(written.emplace_back(folder / name), std::as_bytes(std::span(text)));
  };
  for (const auto& [name, split] : kSplitFiles)
    if (const std::vector<PosedPicture> part = pictures_of_split(pictures, split); !part.empty()) write(name, part);
  write("transforms.json", pictures);
  return written;
}

}  // namespace

LightFieldFormat nerf_format() {
  return {
      .name = "nerf",
      .description = "NeRF's folder: images/000.png, ... and transforms.json with their cameras; planar depth and ray lengths",
      .is_folder = true,
      .uses_cameras = true,
      .keeps_poses = true,
      .keeps_splits = true,
      .states_cameras = true,
      .read = read_nerf,
      .write = write_nerf};
}

}  // namespace lippmann

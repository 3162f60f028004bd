// NeRF data sets: transforms.json (layout/transforms_json.hpp), images/000.png, ... If depth is known, depth/000.npy, ... hold
// planar depth, and depth/000_ray.npy, ... ray lengths.
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

LightField read_nerf(const fs::path& folder, const FormatOptions& options) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;
  fs::path file = folder / "transforms.json";
  if (const fs::path train = folder / "transforms_train.json"; !is_regular_file_there(file) && is_regular_file_there(train))
    file = train;
  const std::string text = read_recorded_text(file, kMaxBytes, "a folder of pictures and transforms.json");
  return read_posed_pictures(folder, file, parse_transforms(text, file.string()), options);
}

std::vector<fs::path> write_nerf(const LightField& field, const fs::path& folder, const FormatOptions&) {
  const std::vector<PosedCamera> cameras = posed_cameras(field, folder.string());
  std::vector<fs::path> written = write_posed_pictures(field, folder);
  if (field.depth) make_folder(folder / "depth");
  std::vector<PosedPicture> pictures;
  for (int view = 0; view < field.grid.count(); ++view) {
    PosedPicture picture;
    picture.picture = posed_picture_name(view, field.grid.count(), exact_ending(field.stack));
    picture.camera = cameras[static_cast<std::size_t>(view)];
    if (field.depth) {
      picture.depth = posed_depth_name(view, field.grid.count());
      for (fs::path& path : write_posed_depth(field, view, picture.camera, folder, picture.depth))
        written.push_back(std::move(path));
    }
    pictures.push_back(std::move(picture));
  }
  const std::string text = transforms_text(pictures);
  write_file_atomically(written.emplace_back(folder / "transforms.json"), std::as_bytes(std::span(text)));
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
      .states_cameras = true,
      .read = read_nerf,
      .write = write_nerf};
}

}  // namespace lippmann

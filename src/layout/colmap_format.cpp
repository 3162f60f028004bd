// COLMAP's folders: images/000.png, ..., sparse/0/cameras.txt, images.txt and points3D.txt (layout/colmap_model.hpp). The
// points are an initial cloud, sampled from the depth of the light field, without tracks. The writer writes text. The reader
// reads text and binary files, and prefers binary files as COLMAP does.
#include <span>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "layout/colmap_model.hpp"
#include "layout/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxModelBytes = std::uintmax_t{1} << 30;

fs::path model_folder(const fs::path& folder) {
  for (const char* inner : {"sparse/0", "sparse", "."})
    for (const char* file : {"cameras.bin", "cameras.txt"})
      if (is_regular_file_there(folder / inner / file)) return folder / inner;
  throw Error(folder.string(), "contains no COLMAP model", "sparse/0 with cameras and images, .txt or .bin");
}

std::vector<PosedPicture> read_colmap_model(const fs::path& model, fs::path& images) {
  if (const fs::path cameras = model / "cameras.bin"; is_regular_file_there(cameras)) {
    images = model / "images.bin";
    const ColmapCameras known = parse_colmap_cameras(read_recorded_bytes(cameras, kMaxModelBytes), cameras.string());
    return parse_colmap_images(read_recorded_bytes(images, kMaxModelBytes), known, images.string());
  }
  const fs::path cameras = model / "cameras.txt";
  images = model / "images.txt";
  const ColmapCameras known = parse_colmap_cameras(read_recorded_text(cameras, kMaxModelBytes), cameras.string());
  return parse_colmap_images(read_recorded_text(images, kMaxModelBytes), known, images.string());
}

LightField read_colmap(const fs::path& folder, const FormatOptions& options) {
  fs::path list;
  std::vector<PosedPicture> pictures = read_colmap_model(model_folder(folder), list);
  std::error_code ignored;
  const fs::path images = folder / "images";
  return read_posed_pictures(fs::is_directory(images, ignored) ? images : folder, list, std::move(pictures), options);
}

std::vector<fs::path> write_colmap(const LightField& field, const fs::path& folder, const FormatOptions&) {
  constexpr std::size_t kMostPoints = 100000;
  const std::vector<PosedCamera> cameras = posed_cameras(field, folder.string());
  std::vector<PosedPicture> pictures;
  for (std::size_t view = 0; view < cameras.size(); ++view) {
    PosedPicture picture;
    picture.picture =
        fs::path(posed_picture_name(static_cast<int>(view), field.grid.count(), exact_ending(field.stack))).filename().string();
    picture.camera = cameras[view];
    pictures.push_back(std::move(picture));
  }
  std::vector<fs::path> written = write_posed_pictures(field, folder);
  const fs::path model = folder / "sparse" / "0";
  make_folder(model);
  const auto write = [&](const char* name, const std::string& text) {
    write_file_atomically(written.emplace_back(model / name), std::as_bytes(std::span(text)));
  };
  write("cameras.txt", colmap_cameras_text(pictures));
  write("images.txt", colmap_images_text(pictures));
  write("points3D.txt", colmap_points_text(point_cloud(field, cameras, kMostPoints)));
  return written;
}

}  // namespace

LightFieldFormat colmap_format() {
  return {
      .name = "colmap",
      .description = "COLMAP's folder: images/000.png, ... and sparse/0 with their cameras, and points where depth is known",
      .is_folder = true,
      .uses_cameras = true,
      .keeps_poses = true,
      .states_cameras = true,
      .read = read_colmap,
      .write = write_colmap};
}

}  // namespace lippmann

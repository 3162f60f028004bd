// COLMAP's folders: images/000.png, ..., sparse/0/cameras, images and points3D as text (.txt) or binary files (.bin)
// (formats/colmap_model.hpp). The writer stores the points of the light field or, if it has none, points sampled from its
// depth. The reader prefers binary files, as COLMAP does.
#include <fmt/format.h>

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "formats/colmap_model.hpp"
#include "formats/picture_folder.hpp"
#include "formats/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

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

/// Reads a COLMAP model. read(path) returns the contents of a file as text or bytes.
template <class Read>
PosedSet read_model(const fs::path& model, const char* ending, const Read& read,
                    const std::function<void(std::string_view)>& warn) {
  const auto file = [&](const char* name) { return model / (std::string(name) + ending); };
  const fs::path cameras = file("cameras"), points = file("points3D");
  PosedSet set{file("images"), {}};
  set.pictures = parse_colmap_images(read(set.file), parse_colmap_cameras(read(cameras), cameras.string()), set.file.string());
  if (!is_regular_file_there(points)) return set;
  ColmapPoints cloud = parse_colmap_points(read(points), points.string());
  if (cloud.tracks > 0 && warn) warn(fmt::format("{}: the tracks of {} points are left out", points.string(), cloud.tracks));
  set.points = std::move(cloud.points);
  return set;
}

/// Warns about pictures that the model does not list. COLMAP does not list pictures whose cameras it could not determine.
void warn_of_unlisted_pictures(const fs::path& images, const fs::path& list, const std::vector<PosedPicture>& pictures,
                               const FormatOptions& options) {
  std::set<fs::path> listed;
  for (const PosedPicture& picture : pictures) listed.insert(fs::path(picture.picture).lexically_normal());
  const auto has_camera = [&](const fs::path& picture) { return listed.contains(picture.filename()); };
  warn_of_pictures_without_camera(images, has_camera, list.filename().string(), options.warn);
}

LightField read_colmap(const fs::path& folder, const FormatOptions& options) {
  const fs::path model = model_folder(folder);
  const auto bytes = [](const fs::path& file) { return read_recorded_bytes(file, kMaxModelBytes); };
  const auto text = [](const fs::path& file) { return read_recorded_text(file, kMaxModelBytes); };
  PosedSet set = is_regular_file_there(model / "cameras.bin") ? read_model(model, ".bin", bytes, options.warn)
                                                              : read_model(model, ".txt", text, options.warn);
  read_held_out_names(model / "test.txt", set.pictures, options.warn);
  std::error_code ignored;
  const fs::path images = folder / "images";
  if (fs::is_directory(images, ignored)) warn_of_unlisted_pictures(images, set.file, set.pictures, options);
  return read_posed_pictures(fs::is_directory(images, ignored) ? images : folder, std::move(set), options);
}

std::vector<fs::path> write_colmap(const LightField& field, const fs::path& folder, const FormatOptions& options) {
  constexpr std::size_t kMostPoints = 100000;
  std::vector<PosedPicture> pictures = listed_pictures(field, folder);
  for (PosedPicture& picture : pictures) picture.picture = fs::path(picture.picture).filename().string();
  const std::vector<CloudPoint> cloud =
      field.points.empty() ? point_cloud(field, posed_cameras(field, folder.string()), kMostPoints) : field.points;
  std::vector<fs::path> written = write_posed_pictures(field, folder);
  const fs::path model = folder / "sparse" / "0";
  make_folder(model);
  const auto write = [&](const char* name, const std::string& contents) {
    write_file_atomically(written.emplace_back(model / name), std::as_bytes(std::span(contents)));
  };
  if (options.binary) {
    write("cameras.bin", colmap_cameras_binary(pictures));
    write("images.bin", colmap_images_binary(pictures));
    write("points3D.bin", colmap_points_binary(cloud));
  } else {
    write("cameras.txt", colmap_cameras_text(pictures));
    write("images.txt", colmap_images_text(pictures));
    write("points3D.txt", colmap_points_text(cloud));
  }
  if (field.splits) write_held_out_names(written.emplace_back(model / "test.txt"), pictures);
  return written;
}

}  // namespace

LightFieldFormat colmap_format() {
  return {
      .name = "colmap",
      .description = "COLMAP's folder: images/000.png, ... and sparse/0 with their cameras, and points where depth is known",
      .is_folder = true,
      .states_cameras = true,
      .read = read_colmap,
      .write = write_colmap,
      .writes = {.binary = true}};
}

}  // namespace lippmann

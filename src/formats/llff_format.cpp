// LLFF's folders: images/000.png, ... and poses_bounds.npy (formats/llff_poses.hpp), which has one row per picture, in the
// order of the pictures' names. Depth bounds come from the depth of the views if it is known. Otherwise, they are the bounds
// that the input states, or the least and greatest depth of its points in each picture.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/folder_entries.hpp"
#include "core/recorded_file.hpp"
#include "formats/frame_names.hpp"
#include "formats/llff_poses.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

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
  read_held_out_names(folder / "test.txt", pictures, options.warn);
  return read_posed_pictures(images, {file, std::move(pictures)}, options);
}

/// Returns the least and greatest depth of the points that are in the camera's picture; none if no point is.
std::optional<Vec2d> bounds_of_points(const std::vector<CloudPoint>& points, const PosedCamera& camera) {
  std::optional<Vec2d> bounds;
  for (const CloudPoint& point : points) {
    const double depth = -(glm::transpose(camera.rotation) * (point.position_mm - camera.position_mm)).z;
    if (!(depth > 0.0)) continue;
    const Vec2d pixel = projected(camera, point.position_mm);
    if (!(pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < camera.size.x && pixel.y < camera.size.y)) continue;
    bounds = bounds ? Vec2d(std::min(bounds->x, depth), std::max(bounds->y, depth)) : Vec2d(depth);
  }
  return bounds;
}

std::vector<Vec2d> bounds_of_views(const LightField& field, const std::vector<PosedCamera>& cameras, const fs::path& folder,
                                   const FormatOptions& options) {
  const Vec2d of_depth = depth_bounds_mm(field);
  if (field.depth) return std::vector<Vec2d>(cameras.size(), of_depth);
  if (field.depth_bounds_mm) return *field.depth_bounds_mm;
  std::vector<Vec2d> bounds;
  bool is_known = true;
  for (const PosedCamera& camera : cameras) {
    const std::optional<Vec2d> seen = bounds_of_points(field.points, camera);
    is_known = is_known && seen;
    bounds.push_back(seen.value_or(of_depth));
  }
  if (!is_known && options.warn)
    options.warn(fmt::format("{}: depth is unknown for some views; assumed: from {:g} m to {:g} m",
                             (folder / "poses_bounds.npy").string(), of_depth.x / 1000.0, of_depth.y / 1000.0));
  return bounds;
}

std::vector<fs::path> write_llff(const LightField& field, const fs::path& folder, const FormatOptions& options) {
  const std::vector<PosedCamera> cameras = posed_cameras(field, folder.string());
  const std::vector<std::byte> poses =
      encode_llff_poses(cameras, bounds_of_views(field, cameras, folder, options), folder.string());
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
          .states_cameras = true,
          .read = read_llff,
          .write = write_llff};
}

}  // namespace lippmann

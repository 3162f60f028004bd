// Folders of MIV and RVS: pictures, and cameras.json, which lists them. If depth is known, <name>_depth.png has depth
// maps of 16-bit codes.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "core/atomic_file.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "formats/miv_cameras.hpp"
#include "formats/picture_folder.hpp"
#include "formats/stated_cameras.hpp"
#include "formats/view_files.hpp"
#include "layout/cameras.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDepthEnding = "_depth.png";
constexpr double kHighest = 65535.0;
/// 16-bit code of the farthest point. TMIV rounds codes to 10 bits, so codes below 64 might become 0, which means no surface.
constexpr double kFarthestCode = 64.0;
constexpr double kLeastRange = 1.001;  // lowest ratio of the farthest to the nearest depth of a depth range

std::vector<MivCamera> read_cameras(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{16} << 20;
  return parse_miv_cameras(read_recorded_text(path, kMaxBytes, "a folder of pictures and cameras.json"), path.string());
}

fs::path picture_of(const fs::path& folder, const MivCamera& camera) {
  for (const char* ending : {".png", ".exr", ".ppm", ".tif", ".jpg"})
    if (const fs::path path = folder / (camera.name + ending); is_regular_file_there(path)) return path;
  throw Error(folder.string(), fmt::format("the picture of camera {} is missing", camera.name), camera.name + ".png");
}

/// Returns a depth map as z in the display frame, or in the camera's frame if distance_mm is 0.
Image read_depth(const fs::path& path, const MivCamera& camera, double distance_mm, Vec2i size) {
  const Picture picture = read_picture(path);
  const auto* codes = std::get_if<Image16>(&picture);
  if (codes == nullptr || size_of(picture) != size)
    throw Error(path.string(), "does not match its view",
                fmt::format("a depth map of {}x{} pixels with 16 bits", size.x, size.y));
  Image depth(size.x, size.y, 1);
  for (std::size_t i = 0; i < depth.data.size(); ++i) {
    const double share = codes->rgb[3 * i] / kHighest;
    const double metres = 1.0 / (share * (1.0 / camera.near_m - 1.0 / camera.far_m) + 1.0 / camera.far_m);
    depth.data[i] = codes->rgb[3 * i] == 0 ? -kInfinity : static_cast<float>(distance_mm - 1e3 * metres);
  }
  return depth;
}

/// Reads the depth of all views. If any view has no depth, field.depth stays empty.
void read_depth(const fs::path& folder, const std::vector<MivCamera>& cameras, const FormatOptions& options,
                LightField& field) {
  std::vector<fs::path> maps;
  for (const MivCamera& camera : cameras) maps.push_back(folder / (camera.name + kDepthEnding));
  if (!has_all_depth_maps(maps, field, options)) return;
  for (const MivCamera& camera : cameras)
    if (camera.depth_bits != 16)
      throw Error((folder / "cameras.json").string(),
                  fmt::format("the BitDepthDepth of camera {} is {}", camera.name, camera.depth_bits),
                  "16, with codes from 1 to 65535 in its depth map");
  field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
  const double distance_mm = field.cameras ? field.cameras->distance_mm : 0.0;
  for (std::size_t view = 0; view < cameras.size(); ++view)
    set_depth(field, static_cast<int>(view), read_depth(maps[view], cameras[view], distance_mm, field.view_size));
}

/// Throws Error if the picture of a camera has another size than the camera.
void require_size(const MivCamera& camera, const fs::path& file, const fs::path& picture, Vec2i size) {
  if (size != camera.resolution)
    throw Error(file.string(),
                fmt::format("the Resolution of camera {} is {}x{}, but {} has {}x{} pixels", camera.name, camera.resolution.x,
                            camera.resolution.y, picture.filename().string(), size.x, size.y),
                "the size of the picture");
}

/// Warns about pictures without a camera, or about missing cameras in a grid.
void warn_of_lost_cameras(const fs::path& folder, const std::vector<MivCamera>& cameras, const FormatOptions& options) {
  std::set<std::string> known{"viewport"};  // TMIV's name of the view that it synthesizes
  for (const MivCamera& camera : cameras) known.insert(camera.name);
  const auto has_camera = [&](const fs::path& picture) {
    return known.contains(picture.stem().string()) || picture.filename().string().ends_with(kDepthEnding);
  };
  if (!warn_of_pictures_without_camera(folder, has_camera, "cameras.json", options.warn))
    warn_of_missing_cameras(cameras, (folder / "cameras.json").string(), options);
}

LightField read_miv(const fs::path& folder, const FormatOptions& options) {
  std::vector<MivCamera> cameras = read_cameras(folder / "cameras.json");
  if (cameras.empty()) throw Error((folder / "cameras.json").string(), "has no cameras");
  sort_as_views(cameras);
  const ViewGrid grid = grid_of_cameras(cameras, options.views, folder.string());
  std::vector<fs::path> by_view;
  for (const MivCamera& camera : cameras) by_view.push_back(picture_of(folder, camera));
  warn_of_lost_cameras(folder, cameras, options);
  LightField field =
      read_view_files(by_view, grid, with_pixel_aspect(options, cameras.front().focal_px), [&](int view, Vec2i size) {
        const auto index = static_cast<std::size_t>(view);
        require_size(cameras[index], folder / "cameras.json", by_view[index], size);
      });
  if (options.fit_view) return field;  // views that fit_view has resized do not match the cameras and the depth maps
  set_cameras(cameras, field);
  read_depth(folder, cameras, options, field);
  return field;
}

struct DepthRange {
  double near_m = 0.1, far_m = 100.0;
};

/// Returns the depth range of the codes. It extends beyond the farthest surface, which gets the code kFarthestCode if possible.
DepthRange depth_range(const LightField& field) {
  double nearest = INFINITY, farthest = 0.0;
  for (const float z : field.depth->data) {
    const double depth = 1e-3 * planar_depth_mm(field, z);
    if (!(depth > 0.0) || !std::isfinite(depth)) continue;
    nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  }
  if (!std::isfinite(nearest)) return {};
  farthest = std::max(farthest, kLeastRange * nearest);
  const double share = kFarthestCode / kHighest;
  return {nearest, 1.0 / std::max((1.0 / farthest - share / nearest) / (1.0 - share), 1e-3 / farthest)};
}

Image16 depth_codes(const LightField& field, int view, const DepthRange& range) {
  const Image depth = depth_of(field, view);
  Image16 codes{depth.width, depth.height, {}};
  for (const float z : depth.data) {
    const double metres = 1e-3 * planar_depth_mm(field, z);
    const double share = (1.0 / metres - 1.0 / range.far_m) / (1.0 / range.near_m - 1.0 / range.far_m);
    const bool there = std::isfinite(metres) && metres > 0.0;
    const auto code = static_cast<std::uint16_t>(there ? std::clamp(std::round(kHighest * share), 1.0, kHighest) : 0.0);
    for (int c = 0; c < 3; ++c) codes.rgb.push_back(code);
  }
  return codes;
}

std::vector<fs::path> write_miv(const LightField& field, const fs::path& folder, const FormatOptions&) {
  if (!field.cameras && !field.poses)
    throw Error(folder.string(), "cannot be written: " + unknown_cameras(field),
                "pictures with render's report.json beside them, or a folder whose files state cameras");
  const auto name = [](int view) { return fmt::format("view_{:03}", view); };
  const char* ending = exact_ending(field.stack);
  std::vector<fs::path> written =
      write_view_files(field, folder, [&](int view) { return fmt::format("{}.{}", name(view), ending); });
  const DepthRange range = field.depth ? depth_range(field) : DepthRange{};
  std::vector<std::string> names;
  for (int view = 0; view < field.grid.count(); ++view) {
    names.push_back(name(view));
    if (!field.depth) continue;
    written.push_back(folder / (name(view) + kDepthEnding));
    write_picture(written.back(), depth_codes(field, view, range));
  }
  const std::string text = miv_cameras_text(miv_cameras(field, names, range.near_m, range.far_m), folder.filename().string(),
                                            field.depth.has_value());
  write_file_atomically(folder / "cameras.json", std::as_bytes(std::span(text)));
  written.push_back(folder / "cameras.json");
  return written;
}

}  // namespace

LightFieldFormat miv_format() {
  return {.name = "miv",
          .description = "a folder of pictures and cameras.json (MIV, RVS); 16-bit depth",
          .is_folder = true,
          .states_cameras = true,
          .read = read_miv,
          .write = write_miv};
}

}  // namespace lippmann

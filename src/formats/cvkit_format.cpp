// cvkit's folders: view_000.png, ... with their cameras in view_000_param.txt, ... (formats/cvkit_camera.hpp). If depth is
// known, view_000_disp.pfm, ... hold the disparities rho / depth in pixels. rho is the focal length times the distance between
// neighbouring cameras. Infinity means no surface. The reader also accepts other names: NAME.png with NAME_param.txt.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "core/atomic_file.hpp"
#include "core/folder_entries.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "core/text_pattern.hpp"
#include "formats/cvkit_camera.hpp"
#include "formats/picture_folder.hpp"
#include "formats/stated_cameras.hpp"
#include "formats/view_files.hpp"
#include "image/netpbm.hpp"
#include "layout/cameras.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCvkitCameras = 4096;
constexpr double kRhoBaselineMm = 100.0;  ///< in rho, for a single view

/// Reads the cameras of a folder. Sets `rho` to disparity * depth of each camera, by picture name.
std::vector<MivCamera> read_cvkit_cameras(const fs::path& folder, std::map<std::string, double>& rho) {
  static const TextPattern pattern("(.{1,200})_param\\.txt");
  constexpr std::uintmax_t kMaxBytes = 1 << 16;
  std::vector<MivCamera> cameras;
  for (const fs::directory_entry& entry : entries_of(folder, "a folder of view_000.png and view_000_param.txt, ...")) {
    const fs::path& path = entry.path();
    const std::optional<PatternMatch> found = pattern.match(path.filename().string());
    if (!found) continue;
    CvkitCamera read = parse_cvkit_camera(read_recorded_text(path, kMaxBytes, "cvkit's parameters"), path.string());
    read.camera.name = found->groups[1];
    rho[read.camera.name] = read.rho;
    cameras.push_back(std::move(read.camera));
  }
  if (cameras.empty() || cameras.size() > kMaxCvkitCameras)
    throw Error(folder.string(), fmt::format("has {} files NAME_param.txt", cameras.size()),
                fmt::format("1 to {}", kMaxCvkitCameras));
  sort_as_views(cameras);
  return cameras;
}

fs::path picture_of_cvkit(const fs::path& folder, const std::string& name) {
  for (const char* ending : {".png", ".exr", ".ppm", ".pgm", ".tif", ".jpg"})
    if (const fs::path path = folder / (name + ending); is_regular_file_there(path)) return path;
  throw Error(folder.string(), fmt::format("the picture of {}_param.txt is missing", name), name + ".png");
}

fs::path cvkit_camera_path(const fs::path& folder, const std::string& name) { return folder / (name + "_param.txt"); }
fs::path cvkit_disparity_path(const fs::path& folder, const std::string& name) { return folder / (name + "_disp.pfm"); }

/// Reads the depth of all views. If any view has no depth, field.depth stays empty.
void read_cvkit_depth(const fs::path& folder, const std::vector<MivCamera>& cameras, const std::map<std::string, double>& rho,
                      const FormatOptions& options, LightField& field) {
  std::vector<fs::path> maps;
  for (const MivCamera& camera : cameras) maps.push_back(cvkit_disparity_path(folder, camera.name));
  if (!has_all_depth_maps(maps, field, options)) return;
  for (const MivCamera& camera : cameras)
    if (!(rho.at(camera.name) > 0.0))
      return leave_out_depth(field, options, cvkit_camera_path(folder, camera.name).string() + " states no rho");
  const double distance_mm = field.cameras ? field.cameras->distance_mm : 0.0;
  field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
  for (std::size_t view = 0; view < cameras.size(); ++view) {
    const fs::path& path = maps[view];
    Image map = read_pfm(path);
    if (Vec2i(map.width, map.height) != field.view_size || map.channels != 1)
      throw Error(path.string(), fmt::format("has {}x{} pixels and {} channels", map.width, map.height, map.channels),
                  fmt::format("{}x{} pixels and 1 channel, like the views", field.view_size.x, field.view_size.y));
    for (float& d : map.data) {
      const double depth_m = rho.at(cameras[view].name) / static_cast<double>(d);
      const bool is_there = std::isfinite(d) && d > 0.0f;
      d = is_there ? static_cast<float>(distance_mm - 1e3 * depth_m) : -kInfinity;
    }
    set_depth(field, static_cast<int>(view), map);
  }
}

/// Warns about pictures without a camera, or about missing cameras in a grid.
void warn_of_lost_cvkit_cameras(const fs::path& folder, const std::vector<MivCamera>& cameras, const FormatOptions& options) {
  const auto has_camera = [&](const fs::path& picture) {
    const std::string name = picture.stem().string();
    return name.ends_with("_disp") || is_regular_file_there(cvkit_camera_path(folder, name));
  };
  if (!warn_of_pictures_without_camera(folder, has_camera, "NAME_param.txt", options.warn))
    warn_of_missing_cameras(cameras, folder.string(), options);
}

LightField read_cvkit(const fs::path& folder, const FormatOptions& options) {
  std::map<std::string, double> rho;
  const std::vector<MivCamera> cameras = read_cvkit_cameras(folder, rho);
  const ViewGrid grid = grid_of_cameras(cameras, options.views, folder.string());
  std::vector<fs::path> by_view;
  for (const MivCamera& camera : cameras) by_view.push_back(picture_of_cvkit(folder, camera.name));
  warn_of_lost_cvkit_cameras(folder, cameras, options);
  LightField field =
      read_view_files(by_view, grid, with_pixel_aspect(options, cameras.front().focal_px), [&](int view, Vec2i size) {
        const MivCamera& camera = cameras[static_cast<std::size_t>(view)];
        if (camera.resolution != Vec2i(0) && camera.resolution != size)
          throw Error(cvkit_camera_path(folder, camera.name).string(),
                      fmt::format("camera.width and camera.height are {} and {}, but the picture has {}x{} pixels",
                                  camera.resolution.x, camera.resolution.y, size.x, size.y),
                      "the size of the picture");
      });
  if (options.fit_view) return field;  // views that fit_view has resized do not match the cameras and the depth maps
  set_cameras(cameras, field);
  read_cvkit_depth(folder, cameras, rho, options, field);
  return field;
}

Image cvkit_disparity(const LightField& field, int view, double rho) {
  Image map = depth_of(field, view);
  for (float& z : map.data) {
    const double depth_m = 1e-3 * planar_depth_mm(field, z);
    z = std::isfinite(depth_m) && depth_m > 0.0 ? static_cast<float>(rho / depth_m) : kInfinity;
  }
  return map;
}

/// Returns the distance between neighbouring cameras, or 0 if it is unknown.
double step_mm(const LightField& field) {
  if (field.cameras) return mean_step(field.cameras->eyes_mm, field.grid);
  return field.poses->size() > 1 ? glm::distance((*field.poses)[0].position_mm, (*field.poses)[1].position_mm) : 0.0;
}

std::vector<fs::path> write_cvkit(const LightField& field, const fs::path& folder, const FormatOptions&) {
  if (!field.cameras && !field.poses)
    throw Error(folder.string(), "cannot be written: " + unknown_cameras(field),
                "pictures with render's report.json beside them, a folder whose files state cameras, or `baseline`");
  const auto name = [](int view) { return fmt::format("view_{:03}", view); };
  const char* ending = exact_ending(field.stack);
  std::vector<fs::path> written =
      write_view_files(field, folder, [&](int view) { return fmt::format("{}.{}", name(view), ending); });
  const std::vector<MivCamera> cameras =
      miv_cameras(field, std::vector<std::string>(static_cast<std::size_t>(field.grid.count())), 0.0, 0.0);
  const double step = step_mm(field);
  const double rho = 1e-3 * (step > 0.0 ? step : kRhoBaselineMm) * cameras[0].focal_px.x;
  for (int view = 0; view < field.grid.count(); ++view) {
    const std::string text = cvkit_camera_text({cameras[static_cast<std::size_t>(view)], rho});
    written.push_back(cvkit_camera_path(folder, name(view)));
    write_file_atomically(written.back(), std::as_bytes(std::span(text)));
    if (!field.depth) continue;
    written.push_back(cvkit_disparity_path(folder, name(view)));
    write_pfm(written.back(), cvkit_disparity(field, view, rho));
  }
  return written;
}

}  // namespace

LightFieldFormat cvkit_format() {
  return {.name = "cvkit",
          .description =
              "cvkit's folder: view_000.png, view_000_param.txt with its camera, view_000_disp.pfm with disparities, ...",
          .is_folder = true,
          .states_cameras = true,
          .read = read_cvkit,
          .write = write_cvkit,
          .reads = {.views = true}};
}

}  // namespace lippmann

// Folders of MIV and RVS: pictures, and cameras.json, which lists them. If depth is known, <name>_depth.png has depth maps of
// 16-bit codes.
#include <fmt/format.h>

#include <cmath>

#include "core/atomic_file.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "layout/cameras.hpp"
#include "layout/miv_cameras.hpp"
#include "layout/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr double kHighest = 65535.0;
/// The code of the farthest point. TMIV rounds codes to 10 bits: a smaller code might become 0, which means no surface.
constexpr double kFarthestCode = 64.0;

std::vector<MivCamera> read_cameras(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{16} << 20;
  return parse_miv_cameras(read_recorded_text(path, kMaxBytes, "a folder of pictures and cameras.json"), path.string());
}

fs::path picture_of(const fs::path& folder, const MivCamera& camera) {
  for (const char* ending : {".png", ".exr", ".ppm", ".tif", ".jpg"})
    if (const fs::path path = folder / (camera.name + ending); is_regular_file_there(path)) return path;
  throw Error(folder.string(), fmt::format("the picture of camera {} is missing", camera.name), camera.name + ".png");
}

/// Returns the depth map of a camera, converted to z in the display frame; none if the map does not exist.
std::optional<Image> read_depth(const fs::path& folder, const MivCamera& camera, double distance_mm, Vec2i size) {
  const fs::path path = folder / (camera.name + "_depth.png");
  if (!is_regular_file_there(path)) return std::nullopt;
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

/// Reads the depth of all views. If one view has no depth, clears field.depth.
void read_depth(const fs::path& folder, const std::vector<MivCamera>& cameras, LightField& field) {
  for (std::size_t view = 0; view < cameras.size(); ++view) {
    const std::optional<Image> depth = read_depth(folder, cameras[view], field.cameras->distance_mm, field.view_size);
    if (!depth) return field.depth.reset();
    if (view == 0) field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
    set_depth(field, static_cast<int>(view), *depth);
  }
}

LightField read_miv(const fs::path& folder, const FormatOptions& options) {
  std::vector<MivCamera> cameras = read_cameras(folder / "cameras.json");
  if (cameras.empty()) throw Error((folder / "cameras.json").string(), "has no cameras");
  sort_as_views(cameras);
  const ViewGrid grid = grid_of_cameras(cameras, options.views, folder.string());
  std::vector<fs::path> by_view;
  for (const MivCamera& camera : cameras) by_view.push_back(picture_of(folder, camera));
  LightField field = read_view_files(by_view, grid, options);
  field.cameras = cameras_of_miv(cameras);
  if (field.cameras) read_depth(folder, cameras, field);
  return field;
}

struct DepthRange {
  double near_m = 0.1, far_m = 100.0;
};

/// Returns the range of depths of all surfaces. The far end lies beyond the farthest surface, so that this surface has the code
/// kFarthestCode if possible.
DepthRange depth_range(const LightField& field) {
  double nearest = INFINITY, farthest = 0.0;
  for (const float z : field.depth->data) {
    const double depth = 1e-3 * (field.cameras->distance_mm - static_cast<double>(z));
    if (!(depth > 0.0) || !std::isfinite(depth)) continue;
    nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  }
  if (!std::isfinite(nearest)) return {};
  const double share = kFarthestCode / kHighest;
  return {nearest, 1.0 / std::max((1.0 / farthest - share / nearest) / (1.0 - share), 1e-3 / farthest)};
}

Image16 depth_codes(const LightField& field, int view, const DepthRange& range) {
  const Image depth = depth_of(field, view);
  Image16 codes{depth.width, depth.height, {}};
  for (const float z : depth.data) {
    const double metres = 1e-3 * (field.cameras->distance_mm - static_cast<double>(z));
    const double share = (1.0 / metres - 1.0 / range.far_m) / (1.0 / range.near_m - 1.0 / range.far_m);
    const bool there = std::isfinite(metres) && metres > 0.0;
    const auto code = static_cast<std::uint16_t>(there ? std::clamp(std::round(kHighest * share), 1.0, kHighest) : 0.0);
    for (int c = 0; c < 3; ++c) codes.rgb.push_back(code);
  }
  return codes;
}

std::vector<fs::path> write_miv(const LightField& field, const fs::path& folder, const FormatOptions&) {
  if (!field.cameras)
    throw Error(folder.string(), unknown_cameras(field),
                "pictures with render's report.json beside them, or an HCI folder with parameters.cfg");
  const auto name = [](int view) { return fmt::format("view_{:03}", view); };
  const char* ending = exact_ending(field.stack);
  std::vector<fs::path> written =
      write_view_files(field, folder, [&](int view) { return fmt::format("{}.{}", name(view), ending); });
  const DepthRange range = field.depth ? depth_range(field) : DepthRange{};
  std::vector<std::string> names;
  for (int view = 0; view < field.grid.count(); ++view) {
    names.push_back(name(view));
    if (!field.depth) continue;
    written.push_back(folder / (name(view) + "_depth.png"));
    write_picture(written.back(), depth_codes(field, view, range));
  }
  const std::string text = miv_cameras_text(miv_cameras(*field.cameras, field.view_size, names, range.near_m, range.far_m),
                                            folder.filename().string(), field.depth.has_value());
  write_file_atomically(folder / "cameras.json", std::as_bytes(std::span(text)));
  written.push_back(folder / "cameras.json");
  return written;
}

}  // namespace

LightFieldFormat miv_format() {
  return {.name = "miv",
          .description = "a folder of pictures and cameras.json (MIV, RVS); 16-bit depth",
          .is_folder = true,
          .uses_cameras = true,
          .states_cameras = true,
          .read = read_miv,
          .write = write_miv};
}

}  // namespace lippmann

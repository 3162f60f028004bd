// Folders of the 4D light field benchmark:
//   input_Cam000.png, ...              the views, row by row from the top left
//   parameters.cfg                     the cameras (layout/hci_parameters.hpp)
//   gt_depth_lowres_Cam000.pfm, ...    the depth of every view, in metres
//   gt_disp_lowres_Cam000.pfm, ...     the disparity of every view, in pixels
//   gt_depth_lowres.pfm, gt_disp_lowres.pfm    copies of the middle view's maps
//
// Without a surface, depth is inf and disparity is -inf. The disparity of a very distant surface approaches a finite value, the
// negative of `offset` in parameters.cfg.
//
// Honauer, Johannsen, Kondermann, Goldluecke: A dataset and evaluation methodology for depth estimation on 4D light fields,
// ACCV 2016.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text_pattern.hpp"
#include "image/netpbm.hpp"
#include "layout/hci_parameters.hpp"
#include "layout/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Returns the grid that the options state, else the grid in parameters.cfg, else a square grid.
ViewGrid grid_of(const fs::path& folder, int count, const FormatOptions& options,
                 const std::optional<HciParameters>& parameters) {
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
  ViewGrid grid = options.views.value_or(ViewGrid{side, side});
  if (!options.views && parameters) grid = {parameters->columns, parameters->rows};
  if (!options.views && !parameters && side * side != count)
    throw usage_error("views", fmt::format("{} has {} views, which do not form a square grid", folder.string(), count),
                      "CxR, such as 9x1");
  if (grid.count() != count)
    throw Error(folder.string(), fmt::format("has {} views, not {}x{}", count, grid.columns, grid.rows),
                "`views` or parameters.cfg with the right number");
  return grid;
}

fs::path per_view(const fs::path& folder, const char* kind, const ViewGrid& grid, int view) {
  return folder / fmt::format("gt_{}_lowres_Cam{:03}.pfm", kind, from_top_left(grid, view));
}

/// Reads the depth of all views. If any view has no depth, field.depth stays empty.
void read_depth(const fs::path& folder, double focus_distance_mm, const FormatOptions& options, LightField& field) {
  std::vector<fs::path> maps;
  for (int view = 0; view < field.grid.count(); ++view) maps.push_back(per_view(folder, "depth", field.grid, view));
  if (!has_all_depth_maps(maps, field, options)) return;
  field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
  for (int view = 0; view < field.grid.count(); ++view) {
    const fs::path& path = maps[static_cast<std::size_t>(view)];
    Image depth = read_pfm(path);
    if (Vec2i(depth.width, depth.height) != field.view_size || depth.channels != 1)
      throw Error(path.string(), fmt::format("has {}x{} pixels and {} channels", depth.width, depth.height, depth.channels),
                  fmt::format("{}x{} pixels and 1 channel, like the views", field.view_size.x, field.view_size.y));
    for (float& z : depth.data) z = static_cast<float>(focus_distance_mm - 1000.0 * static_cast<double>(z));
    set_depth(field, view, depth);
  }
}

LightField read_hci(const fs::path& folder, const FormatOptions& options) {
  static const TextPattern name("input_Cam([0-9]{1,6})\\.[^.]+", TextPattern::Letters::kEitherCase);
  const std::vector<NumberedFile> files = numbered_files(folder, name, "input_Cam000.png, input_Cam001.png, ...");
  const int count = static_cast<int>(files.size());
  const std::optional<HciParameters> parameters = read_hci_parameters(folder);
  const int stated = parameters && !options.views ? parameters->columns * parameters->rows : 0;
  require_all_views(folder, files, 0, std::max(files.back().numbers[0], stated - 1),
                    [](int number) { return fmt::format("input_Cam{:03}", number); });
  const ViewGrid grid = grid_of(folder, count, options, parameters);
  std::vector<fs::path> by_view(files.size());
  for (int i = 0; i < count; ++i)
    by_view[static_cast<std::size_t>(from_top_left(grid, i))] = files[static_cast<std::size_t>(i)].path;
  LightField field = read_view_files(by_view, grid, options, [&](int view, Vec2i size) {
    if (parameters) require_size(*parameters, by_view[static_cast<std::size_t>(view)], size);
  });
  if (options.fit_view) return field;  // views that fit_view has resized do not match the cameras and the depth maps
  if (parameters && grid == ViewGrid{parameters->columns, parameters->rows}) field.cameras = hci_cameras(*parameters);
  if (field.cameras)
    read_depth(folder, field.cameras->distance_mm, options, field);
  else if (options.cameras)
    read_depth(folder, options.cameras->focus_distance_mm, options, field);
  return field;
}

struct DepthMaps {
  Image depth_m, disparity_px;
};

DepthMaps depth_maps(const LightField& field, int view, const HciParameters& parameters) {
  DepthMaps maps{depth_of(field, view), Image(field.view_size.x, field.view_size.y, 1)};
  for (std::size_t i = 0; i < maps.depth_m.data.size(); ++i) {
    const double depth_m = parameters.focus_distance_m - 1e-3 * static_cast<double>(maps.depth_m.data[i]);
    maps.depth_m.data[i] = static_cast<float>(depth_m);
    maps.disparity_px.data[i] = std::isinf(depth_m) ? -INFINITY : static_cast<float>(hci_disparity_px(parameters, depth_m));
  }
  return maps;
}

/// Writes the depth and disparity maps. Sets the range of disparities in `parameters`, from 0 to 0 if there are no surfaces.
void write_depth(const LightField& field, const fs::path& folder, HciParameters& parameters, std::vector<fs::path>& written) {
  // The middle view, for file names that number the views from the top left.
  const int middle = field.grid.rows / 2 * field.grid.columns + field.grid.columns / 2;
  parameters.disparity_min = INFINITY, parameters.disparity_max = -INFINITY;
  const auto put = [&](const fs::path& path, const Image& map) {
    write_pfm(path, map);
    written.push_back(path);
  };
  for (int view = 0; view < field.grid.count(); ++view) {
    const DepthMaps maps = depth_maps(field, view, parameters);
    for (const float d : maps.disparity_px.data) {
      if (std::isinf(d)) continue;
      parameters.disparity_min = std::min(parameters.disparity_min, static_cast<double>(d));
      parameters.disparity_max = std::max(parameters.disparity_max, static_cast<double>(d));
    }
    put(per_view(folder, "depth", field.grid, view), maps.depth_m);
    put(per_view(folder, "disp", field.grid, view), maps.disparity_px);
    if (from_top_left(field.grid, view) != middle) continue;
    put(folder / "gt_depth_lowres.pfm", maps.depth_m);
    put(folder / "gt_disp_lowres.pfm", maps.disparity_px);
  }
  if (parameters.disparity_min > parameters.disparity_max) parameters.disparity_min = parameters.disparity_max = 0.0;
}

std::vector<fs::path> write_hci(const LightField& field, const fs::path& folder, const FormatOptions&) {
  std::optional<HciParameters> parameters;
  if (field.cameras) parameters = hci_parameters(field, folder.string());
  const char* ending = exact_ending(field.stack);
  std::vector<fs::path> written = write_view_files(
      field, folder, [&](int view) { return fmt::format("input_Cam{:03}.{}", from_top_left(field.grid, view), ending); });
  if (!parameters) return written;
  parameters->scene = folder.filename().string();
  if (field.depth) write_depth(field, folder, *parameters, written);
  written.push_back(write_hci_parameters(folder, *parameters));
  return written;
}

}  // namespace

LightFieldFormat hci_format() {
  return {.name = "hci",
          .description =
              "the 4D light field benchmark's folder: input_Cam000.png, ..., from the top left; cameras, depth, disparity",
          .is_folder = true,
          .uses_cameras = true,
          .assumes_square_pixels = true,
          .states_cameras = true,
          .read = read_hci,
          .write = write_hci,
          .reads = {.views = true}};
}

}  // namespace lippmann

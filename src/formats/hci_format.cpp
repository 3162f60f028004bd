// Folders of the 4D light field benchmark:
//   input_Cam000.png, ...              the views, row by row from the top left
//   parameters.cfg                     the cameras (formats/hci_parameters.hpp)
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
#include <utility>

#include "core/regular_file.hpp"
#include "core/text_pattern.hpp"
#include "formats/hci_parameters.hpp"
#include "formats/view_files.hpp"
#include "image/netpbm.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

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

int middle_view(const ViewGrid& grid) {
  return from_top_left(grid, grid.rows / 2 * grid.columns + grid.columns / 2);  // from_top_left() is its own inverse
}

fs::path middle_map(const fs::path& folder, const char* kind) { return folder / fmt::format("gt_{}_lowres.pfm", kind); }

/// Returns the depth map or, if it is missing, the disparity map, which needs `parameters`.
fs::path depth_or_disparity(const fs::path& depth, const fs::path& disparity, const std::optional<HciParameters>& parameters) {
  return !is_regular_file_there(depth) && parameters && is_regular_file_there(disparity) ? disparity : depth;
}

/// Reads a depth map or a disparity map as z of the display frame.
Image read_map(const fs::path& path, double focus_distance_mm, const std::optional<HciParameters>& parameters,
               Vec2i view_size) {
  Image map = read_pfm(path);
  if (Vec2i(map.width, map.height) != view_size || map.channels != 1)
    throw Error(path.string(), fmt::format("has {}x{} pixels and {} channels", map.width, map.height, map.channels),
                fmt::format("{}x{} pixels and 1 channel, like the views", view_size.x, view_size.y));
  const bool is_disparity = path.filename().string().starts_with("gt_disp");
  for (float& value : map.data) {
    const double depth_m = is_disparity ? hci_depth_m(*parameters, static_cast<double>(value)) : static_cast<double>(value);
    value = static_cast<float>(focus_distance_mm - 1000.0 * depth_m);
  }
  return map;
}

/// Reads the depth of all views, or of the only view that has depth. If more views have depth, but not all, warns.
void read_depth(const fs::path& folder, double focus_distance_mm, const std::optional<HciParameters>& parameters,
                const FormatOptions& options, LightField& field) {
  std::vector<fs::path> maps;
  for (int view = 0; view < field.grid.count(); ++view)
    maps.push_back(depth_or_disparity(per_view(folder, "depth", field.grid, view), per_view(folder, "disp", field.grid, view),
                                      parameters));
  const auto read = [&](const fs::path& path) { return read_map(path, focus_distance_mm, parameters, field.view_size); };
  const auto there = std::ranges::count_if(maps, is_regular_file_there);
  if (there == 0) {
    const fs::path middle = depth_or_disparity(middle_map(folder, "depth"), middle_map(folder, "disp"), parameters);
    if (is_regular_file_there(middle)) field.view_depth = {middle_view(field.grid), read(middle)};
  } else if (there == 1) {
    const auto only = std::ranges::find_if(maps, is_regular_file_there);
    field.view_depth = {static_cast<int>(only - maps.begin()), read(*only)};
  } else if (has_all_depth_maps(maps, field, options)) {
    field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
    for (std::size_t view = 0; view < maps.size(); ++view) set_depth(field, static_cast<int>(view), read(maps[view]));
  }
  if (field.view_depth && field.grid.count() == 1) field.depth = std::exchange(field.view_depth, {})->depth;
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
  if (parameters) field.hci = parameters->notes;
  if (parameters && grid == ViewGrid{parameters->columns, parameters->rows}) field.cameras = hci_cameras(*parameters);
  if (field.cameras)
    read_depth(folder, field.cameras->distance_mm, parameters, options, field);
  else if (options.cameras)
    read_depth(folder, options.cameras->focus_distance_mm, std::nullopt, options, field);
  return field;
}

struct DepthMaps {
  Image depth_m, disparity_px;
};

/// `z_mm`: z of the display frame.
DepthMaps depth_maps(Image z_mm, const HciParameters& parameters) {
  DepthMaps maps{std::move(z_mm), {}};
  maps.disparity_px = Image(maps.depth_m.width, maps.depth_m.height, 1);
  for (std::size_t i = 0; i < maps.depth_m.data.size(); ++i) {
    const double depth_m = parameters.focus_distance_m - 1e-3 * static_cast<double>(maps.depth_m.data[i]);
    maps.depth_m.data[i] = static_cast<float>(depth_m);
    maps.disparity_px.data[i] = std::isinf(depth_m) ? -INFINITY : static_cast<float>(hci_disparity_px(parameters, depth_m));
  }
  return maps;
}

/// Writes depth and disparity maps of a field with `depth` or `view_depth`. Returns the range of disparities, from 0 to 0 if
/// there are no surfaces.
Vec2d write_depth(const LightField& field, const fs::path& folder, const HciParameters& parameters,
                  std::vector<fs::path>& written) {
  const int middle = middle_view(field.grid);
  Vec2d range(INFINITY, -INFINITY);
  const auto put = [&](const fs::path& path, const Image& map) {
    write_pfm(path, map);
    written.push_back(path);
  };
  for (int view = 0; view < field.grid.count(); ++view) {
    if (!field.depth && view != field.view_depth->view) continue;
    const DepthMaps maps = depth_maps(field.depth ? depth_of(field, view) : field.view_depth->depth, parameters);
    for (const float d : maps.disparity_px.data)
      if (!std::isinf(d)) range = {std::min(range.x, static_cast<double>(d)), std::max(range.y, static_cast<double>(d))};
    if (field.depth || view != middle) {
      put(per_view(folder, "depth", field.grid, view), maps.depth_m);
      put(per_view(folder, "disp", field.grid, view), maps.disparity_px);
    }
    if (view != middle) continue;
    put(middle_map(folder, "depth"), maps.depth_m);
    put(middle_map(folder, "disp"), maps.disparity_px);
  }
  return range.x > range.y ? Vec2d(0.0) : range;
}

std::vector<fs::path> write_hci(const LightField& field, const fs::path& folder, const FormatOptions&) {
  std::optional<HciParameters> parameters;
  if (field.cameras) parameters = hci_parameters(field, folder.string());
  const char* ending = exact_ending(field.stack);
  std::vector<fs::path> written = write_view_files(
      field, folder, [&](int view) { return fmt::format("input_Cam{:03}.{}", from_top_left(field.grid, view), ending); });
  if (!parameters) return written;
  HciNotes& notes = parameters->notes;
  const bool has_depth = field.depth || field.view_depth;
  const Vec2d disparity_px = has_depth ? write_depth(field, folder, *parameters, written) : Vec2d(0.0);
  if (notes.disparity_px == Vec2d(0.0)) notes.disparity_px = disparity_px;
  if (notes.frustum_disparity_px == Vec2d(0.0)) notes.frustum_disparity_px = notes.disparity_px;
  written.push_back(write_hci_parameters(folder, *parameters));
  return written;
}

}  // namespace

LightFieldFormat hci_format() {
  return {.name = "hci",
          .description =
              "the 4D light field benchmark's folder: input_Cam000.png, ..., from the top left; cameras, depth, disparity",
          .is_folder = true,
          .states_cameras = true,
          .read = read_hci,
          .write = write_hci,
          .reads = {.views = true}};
}

}  // namespace lippmann

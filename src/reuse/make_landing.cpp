#include "reuse/make_landing.hpp"

#include "lippmann/core/error.hpp"
#include "optics/multi_view.hpp"
#include "optics/single_view.hpp"
#include "reuse/move_points.hpp"

namespace lippmann {
namespace {

GridLanding empty_grid(const Panel& panel, double vergence, int sets) {
  GridLanding grid{};
  grid.c.vergence = static_cast<float>(vergence);
  grid.width = panel.width;
  const std::size_t columns = static_cast<std::size_t>(panel.width) * static_cast<std::size_t>(sets) + kPointLanes;
  grid.place.resize(columns), grid.slope.resize(columns), grid.first.resize(columns), grid.low.resize(columns),
      grid.high.resize(columns);
  grid.lines.resize(static_cast<std::size_t>(panel.height));
  grid.set_of_row.resize(static_cast<std::size_t>(panel.height), 0);
  return grid;
}

void set_column(GridLanding& grid, int set, int i, const GridLine& line) {
  const std::size_t at = static_cast<std::size_t>(set) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(i);
  grid.place[at] = line.place, grid.slope[at] = line.slope, grid.first[at] = line.first, grid.low[at] = line.low,
  grid.high[at] = line.high;
}

GridScale scale_of(const LensAxis<double>& axis) {
  return {static_cast<float>(1.0 / axis.pitch_mm), static_cast<float>(0.5 - axis.lens0_mm / axis.pitch_mm),
          static_cast<float>(axis.whole_pixels)};
}

GridLine line_of(const LensAxis<double>& axis, int pixel, int size) {
  const int lens = pixel / axis.whole_pixels, view = pixel % axis.whole_pixels;
  const double offset = view + 0.5 - 0.5 * axis.cell_px;
  return {static_cast<float>(axis.lens0_mm + lens * axis.pitch_mm),
          static_cast<float>(offset * axis.slope_per_px - axis.eye_mm * axis.vergence), static_cast<float>(view), 0.0f,
          static_cast<float>(size - 1)};
}

/// Returns the line of pixel i of the panel, in a view with one sample per pixel. The view begins at pixel `first`.
GridLine plain_line(const GridScale& scale, double slope, int i, int first, int low, int high) {
  const double place = (i - first + 0.5 - scale.shift) / scale.samples_per_mm;
  return {static_cast<float>(place), static_cast<float>(slope), static_cast<float>(first), static_cast<float>(low),
          static_cast<float>(high)};
}

/// Returns the rows of a lenticular sheet. If a ray crosses z = 0 at the height y (mm), its row is floor(shift - y *
/// samples_per_mm).
GridScale sheet_rows(const LenticularConstants<double>& c) {
  const double spread = 1.0 + c.gap_mm * c.axis.vergence;
  return {static_cast<float>(spread / c.pixel_pitch_mm),
          static_cast<float>(c.half_height_px + c.eye_y_mm * c.gap_mm * c.axis.vergence / c.pixel_pitch_mm), 1.0f};
}

GridLanding sheet_grid(const Panel& panel, const LenticularConstants<double>& c) {
  GridLanding grid = empty_grid(panel, c.axis.vergence, 1);
  grid.c.across = scale_of(c.axis), grid.c.down = sheet_rows(c);
  for (int i = 0; i < panel.width; ++i) set_column(grid, 0, i, line_of(c.axis, i, panel.width));
  for (int j = 0; j < panel.height; ++j)
    grid.lines[static_cast<std::size_t>(j)] = plain_line(grid.c.down, c.eye_y_mm * c.axis.vergence, j, 0, 0, panel.height - 1);
  return grid;
}

GridLanding microlens_grid(const Panel& panel, const MicrolensConstants<double>& c) {
  GridLanding grid = empty_grid(panel, c.columns.vergence, 1);
  grid.c.across = scale_of(c.columns), grid.c.down = scale_of(c.rows);
  for (int i = 0; i < panel.width; ++i) set_column(grid, 0, i, line_of(c.columns, i, panel.width));
  for (int j = 0; j < panel.height; ++j) grid.lines[static_cast<std::size_t>(j)] = line_of(c.rows, j, panel.height);
  return grid;
}

/// Returns the landing rule of a quilt. Padding pixels belong to the adjacent view.
GridLanding views_grid(const Panel& panel, const MultiView& views) {
  const MultiViewRays c = make_multi_view(panel, views, 0.0f);
  const int tile_width = panel.width / views.columns, tile_height = panel.height / views.rows;
  const int padding = panel.height - views.rows * tile_height;
  const float per_mm = 1.0f / panel.pixel_pitch_mm;
  GridLanding grid = empty_grid(panel, c.inverse_distance, views.rows);
  grid.c.across = {per_mm, 0.5f * c.tile_width_px, 1.0f};
  grid.c.down = {1.0f / c.pixel_height_mm, 0.5f * c.tile_height_px, 1.0f};
  for (int row = 0; row < views.rows; ++row)
    for (int i = 0; i < panel.width; ++i) {
      const int column = std::min(i / tile_width, views.columns - 1), first = column * tile_width;
      const int last = column == views.columns - 1 ? panel.width - 1 : first + tile_width - 1;
      const int view = (views.rows - 1 - row) * views.columns + column;
      const float on_cone =
          views.parallax * tangent_of_double(c.first_half_angle + static_cast<float>(view) * c.half_angle_step);
      const float in_grid = (c.first_eye_mm.x + static_cast<float>(column) * c.baseline_mm) * c.inverse_distance;
      set_column(grid, row, i, plain_line(grid.c.across, -(on_cone + in_grid), i, first, first, last));
    }
  for (int j = 0; j < panel.height; ++j) {
    const int row = std::max(0, j - padding) / tile_height, first = padding + row * tile_height;
    grid.set_of_row[static_cast<std::size_t>(j)] = row;
    // `row` counts from the top, but eyes are numbered from the bottom.
    const float eye = c.first_eye_mm.y + static_cast<float>(views.rows - 1 - row) * c.baseline_mm;
    grid.lines[static_cast<std::size_t>(j)] =
        plain_line(grid.c.down, eye * c.inverse_distance, j, first, row == 0 ? 0 : first, first + tile_height - 1);
  }
  return grid;
}

GridLanding single_grid(const Panel& panel, const SingleView& view) {
  const SingleViewRays c = make_single_view(panel, view, 0.0f);
  const float per_mm = 1.0f / panel.pixel_pitch_mm;
  GridLanding grid = empty_grid(panel, c.inverse_distance, 1);
  grid.c.across = {per_mm, c.centre_x_px, 1.0f}, grid.c.down = {per_mm, c.centre_y_px, 1.0f};
  for (int i = 0; i < panel.width; ++i) set_column(grid, 0, i, plain_line(grid.c.across, 0.0, i, 0, 0, panel.width - 1));
  for (int j = 0; j < panel.height; ++j)
    grid.lines[static_cast<std::size_t>(j)] =
        plain_line(grid.c.down, c.eye_y_mm * c.inverse_distance, j, 0, 0, panel.height - 1);
  return grid;
}

template <SplatMode mode>
SheetLanding<mode> sheet_landing(const Panel& panel, const LenticularConstants<double>& c) {
  return {{c.as<float>(), sheet_rows(c), static_cast<float>(c.eye_y_mm * c.axis.vergence), static_cast<float>(panel.width),
           static_cast<float>(panel.height), 0.0f, 0.0f}};
}

AnyLanding landing(const Panel& panel, const LenticularSheet& sheet, SplatMode mode) {
  const LenticularConstants<double> c = make_lenticular(panel, sheet, 0.0);
  if (mode == SplatMode::kLens) return sheet_landing<SplatMode::kLens>(panel, c);
  if (c.axis.whole_pixels > 0) return sheet_grid(panel, c);
  return sheet_landing<SplatMode::kView>(panel, c);
}

template <SplatMode mode>
AnyLanding microlens_landing(const Panel& panel, const MicrolensConstants<double>& c, LensPacking packing) {
  const auto width = static_cast<float>(panel.width), height = static_cast<float>(panel.height);
  if (packing == LensPacking::kHexagonal) return HexagonLanding<mode>{{c.as<float>(), width, height, 0.0f, 0.0f}};
  return SquareLanding<mode>{{c.as<float>(), width, height, 0.0f, 0.0f}};
}

AnyLanding landing(const Panel& panel, const MicrolensArray& array, SplatMode mode) {
  const MicrolensConstants<double> c = make_microlens(panel, array, 0.0);
  if (mode == SplatMode::kLens) return microlens_landing<SplatMode::kLens>(panel, c, array.packing);
  if (c.columns.whole_pixels > 0 && c.rows.whole_pixels > 0) return microlens_grid(panel, c);
  return microlens_landing<SplatMode::kView>(panel, c, array.packing);
}

AnyLanding landing(const Panel& panel, const MultiView& views, SplatMode) { return views_grid(panel, views); }
AnyLanding landing(const Panel& panel, const SingleView& view, SplatMode) { return single_grid(panel, view); }

AnyLanding landing(const Panel& panel, const SlantedPanel& slanted, SplatMode mode) {
  if (mode == SplatMode::kLens)
    throw usage_error("splat", "lens does not work for a slanted panel, whose lenses cross its rows", "`splat` view");
  const bool blue_first = slanted.sub_pixels == striped_sub_pixels(true);
  if (!blue_first && slanted.sub_pixels != striped_sub_pixels())
    throw usage_error("reuse", "interpolate needs panels with striped sub-pixels", "`reuse` copy or none, or `layout` quilt");
  const SlantedPanelRays c = make_slanted_panel(panel, slanted, 0.0f);
  const auto width = static_cast<float>(3 * panel.width), height = static_cast<float>(panel.height);
  const double per_sub_pixel = c.lenses_per_px / 3.0;
  return SlantedLanding{{c, static_cast<float>(per_sub_pixel), static_cast<float>(1.0 / per_sub_pixel),
                         static_cast<float>(-c.lenses_per_row), 3.0f / panel.pixel_pitch_mm, width, height, 0.5f * width,
                         0.5f * height, blue_first ? -1.0f : 1.0f, 0.0f, 0.0f}};
}

template <class Model>
AnyLanding landing(const Panel&, const Model&, SplatMode) {
  throw usage_error("reuse", "interpolate cannot project points to the pixels of these optics", "`reuse` copy, none or auto");
}

}  // namespace

AnyLanding make_landing(const Optics& optics, SplatMode mode) {
  return std::visit([&](const auto& model) { return landing(optics.panel, model, mode); }, optics.model);
}

}  // namespace lippmann

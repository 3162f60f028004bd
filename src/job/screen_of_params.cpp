#include "job/screen_of_params.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <variant>

#include "job/panel_size.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr float kLensWidthMm = 1.0f;     ///< how wide a cell is on the panel
constexpr float kSingleWidthMm = 64.0f;  ///< how wide a view without lenses is: as wide as 64 lenses
constexpr float kViewAngleDeg = 28.0f;   ///< where nobody says
constexpr float kViewerHeights = 3.0f;   ///< where nobody says how far the viewer stands: as one does before a picture

float view_angle_deg(const RenderParams& params) { return params.optics.view_angle_deg.value_or(kViewAngleDeg); }

/// The centre of the cell nearest to the panel's middle, when a cell begins at the panel's edge, `extent` wide.
float cell_center_nearest_middle(float extent, float cell) {
  const float middle = 0.5f * extent;
  return (std::floor(middle / cell) + 0.5f) * cell - middle;
}

struct LensGeometry {
  float pitch_mm, gap_mm, pitch_per_cell;
};

LensGeometry lens_geometry(float cell_mm, float view_angle_deg, float viewing_distance_mm) {
  const float gap = cell_mm / (2.0f * std::tan(0.5f * radians(view_angle_deg)));
  const float pitch_per_cell = 1.0f / (1.0f + gap / viewing_distance_mm);
  return {cell_mm * pitch_per_cell, gap, pitch_per_cell};
}

LenticularSheet lenticular_sheet(const RenderParams& params, const Panel& panel, float lens_pixels, float distance_mm) {
  LenticularSheet sheet;
  sheet.slant = radians(params.optics.slant_deg);
  const float cell = lens_pixels * panel.pixel_pitch_mm * std::cos(sheet.slant);  // lens_pixels counts along a pixel row
  const LensGeometry lens = lens_geometry(cell, view_angle_deg(params), distance_mm);
  const float width = static_cast<float>(panel.width) * panel.pixel_pitch_mm * std::cos(sheet.slant);
  sheet.lens_pitch_mm = lens.pitch_mm;
  sheet.gap_mm = lens.gap_mm;
  sheet.offset_mm = cell_center_nearest_middle(width, cell) * lens.pitch_per_cell;
  sheet.viewing_distance_mm = distance_mm;
  return sheet;
}

MicrolensArray microlens_array(const RenderParams& params, const Panel& panel, float lens_pixels, float distance_mm) {
  MicrolensArray array;
  const float cell = lens_pixels * panel.pixel_pitch_mm;
  const float row = params.optics.packing == LensPacking::kHexagonal ? cell * std::sqrt(0.75f) : cell;
  const LensGeometry lens = lens_geometry(cell, view_angle_deg(params), distance_mm);
  const Vec2f extent = Vec2f(panel.width, panel.height) * panel.pixel_pitch_mm;
  array.packing = params.optics.packing;
  array.lens_pitch_mm = lens.pitch_mm;
  array.gap_mm = lens.gap_mm;
  array.offset_mm =
      Vec2f(cell_center_nearest_middle(extent.x, cell), cell_center_nearest_middle(extent.y, row)) * lens.pitch_per_cell;
  array.viewing_distance_mm = distance_mm;
  return array;
}

OpticsModel make_model(const RenderParams& params, const Panel& panel, const PanelSize& size, const Scene& scene,
                       float distance_mm) {
  switch (optics_kind(params)) {
    case OpticsKind::kLenticular:
      return lenticular_sheet(params, panel, size.lens_pixels, distance_mm);
    case OpticsKind::kMicrolens:
      return microlens_array(params, panel, size.lens_pixels, distance_mm);
    case OpticsKind::kMultiview: {
      const Extent<int> views = quilt_views(params);
      MultiView model{views.x, views.y, radians(view_angle_deg(params)), false, distance_mm};
      if (params.optics.camera_grid)
        model.baseline_mm =
            2.0f * distance_mm * std::tan(0.5f * model.view_cone) / static_cast<float>(std::max(views.x, views.y));
      return model;
    }
    case OpticsKind::kSingle:
      break;
  }
  return SingleView{distance_mm, scene.cameras.empty() ? Vec2f(0.0f) : scene.cameras.front().pixel_offset};
}

Panel make_panel(const PanelSize& size, int columns) {
  const float view_width = static_cast<float>(size.width) / static_cast<float>(columns);
  return {size.width, size.height, size.lens_pixels > 0.0f ? kLensWidthMm / size.lens_pixels : kSingleWidthMm / view_width};
}

/// Where the cells converge (lens arrays) or the eyes stand (the others, which need one at a finite distance).
float viewing_distance_mm(const RenderParams& params, float fitted_mm, float window_height_mm) {
  const bool lenses = optics_kind(params) == OpticsKind::kLenticular || optics_kind(params) == OpticsKind::kMicrolens;
  const float distance = params.optics.viewing_distance_mm.value_or(fitted_mm);
  if (lenses || std::isfinite(distance)) return distance;
  if (params.optics.viewing_distance_mm)
    throw usage_error("--viewing-distance", "cannot be infinite without lenses", "millimetres above 0, or auto");
  return kViewerHeights * window_height_mm;
}

/// From close to, lenses must lie closer than the cells behind them: below a pixel's width they hold no picture.
void require_lenses_of_a_pixel(float lens_pitch_mm, float gap_mm, float viewing_distance_mm, const Panel& panel) {
  if (!(lens_pitch_mm < 0.999f * panel.pixel_pitch_mm)) return;  // 0.999: rounding, as in validate
  throw usage_error(
      "--viewing-distance",
      fmt::format("a viewer {:.4g} mm before lenses {:.4g} mm before the pixels: the lenses would lie closer than "
                  "pixels",
                  viewing_distance_mm, gap_mm),
      "a longer distance, a wider --view-angle or more --lens-pixels");
}

void check_lens(const Optics& optics) {
  if (const std::optional<LensArray> lenses = lens_array(optics))
    require_lenses_of_a_pixel(lenses->lens_pitch_mm, static_cast<float>(lenses->gap_mm),
                              static_cast<float>(lenses->viewing_distance_mm), optics.panel);
}

}  // namespace

Screen screen_of_params(const RenderParams& params, const Scene& scene) {
  const PanelSize size = panel_size(params, scene.resolution);
  const Extent<int> views = optics_kind(params) == OpticsKind::kMultiview ? quilt_views(params) : Extent<int>{1, 1};
  const Panel panel = make_panel(size, views.x);
  const auto optics_for = [params, &scene, size, views, panel](const FittedArray& array) {
    const float window_height_mm = static_cast<float>(size.height / views.y) * panel.pixel_pitch_mm;
    const float fitted_mm = array.viewing_distance / scene_units_per_mm(array, window_height_mm);
    const float distance_mm = viewing_distance_mm(params, fitted_mm, window_height_mm);
    Optics optics;
    optics.panel = panel;
    optics.model = make_model(params, panel, size, scene, distance_mm);
    check_lens(optics);
    return optics;
  };
  return {static_cast<float>(size.width / views.x) / static_cast<float>(size.height / views.y), optics_for};
}

}  // namespace lippmann

#include "layout/cameras.hpp"

#include <algorithm>
#include <cmath>

#include "optics/multi_view.hpp"

namespace lippmann {
namespace {

/// Eyes of an array with n pixels below a lens, from the lower left one, eye_step_mm apart.
std::vector<Vec2d> lens_eyes(Vec2i n, double eye_step_mm, double eye_height_mm) {
  std::vector<Vec2d> eyes;
  for (int row = 0; row < n.y; ++row)
    for (int column = 0; column < n.x; ++column)
      eyes.emplace_back((column - 0.5 * (n.x - 1)) * eye_step_mm, eye_height_mm + (row - 0.5 * (n.y - 1)) * eye_step_mm);
  return eyes;
}

std::optional<ViewCameras> lens_cameras(const Panel& panel, const LenticularSheet& sheet, Vec2i n) {
  const double v = sheet.viewing_distance_mm, g = sheet.gap_mm, m = panel.pixel_pitch_mm;
  if (!std::isfinite(v)) return std::nullopt;
  // Rows are told from the middle of the panel; the height of the eye shifts them towards it in the plane of the lenses.
  const Vec2d centre(0.5 * panel.width / n.x, 0.5 * panel.height + g * sheet.eye_height_mm / (v * m));
  return ViewCameras{
      v, {sheet.lens_pitch_mm, m * v / (v + g)}, centre, lens_eyes(n, sheet.parallax * m * v / g, sheet.eye_height_mm)};
}

std::optional<ViewCameras> lens_cameras(const Panel& panel, const MicrolensArray& array, Vec2i n) {
  const double v = array.viewing_distance_mm, g = array.gap_mm, m = panel.pixel_pitch_mm;
  if (!std::isfinite(v)) return std::nullopt;
  const Vec2d centre(0.5 * panel.width / n.x, 0.5 * panel.height / n.y);
  return ViewCameras{v, Vec2d(array.lens_pitch_mm), centre, lens_eyes(n, array.parallax * m * v / g, 0.0)};
}

RenderedViews views_of(const Panel& panel, const MultiView& model) {
  const ViewGrid tiles{model.columns, model.rows};
  const Vec2d pixel_mm = Vec2d(1.0, model.pixel_height) * double(panel.pixel_pitch_mm);
  ViewCameras cameras{model.distance_mm, pixel_mm, {}, {}};
  cameras.centre_px = 0.5 * Vec2d(panel.width / model.columns, panel.height / model.rows);
  for (int view = 0; view < tiles.count(); ++view) {
    const EyeMm eye = eye_of_view(model, view);
    cameras.eyes_mm.emplace_back(eye.x, eye.y);
  }
  return {{LayoutKind::kQuilt, model.baseline_mm > 0.0f ? tiles : ViewGrid{tiles.count(), 1}, tiles}, cameras};
}

}  // namespace

std::optional<RenderedViews> rendered_views(const Optics& optics) {
  const Panel& panel = optics.panel;
  if (const auto* views = std::get_if<MultiView>(&optics.model)) return views_of(panel, *views);
  if (const auto* view = std::get_if<SingleView>(&optics.model)) {
    const Vec2d centre = 0.5 * Vec2d(panel.width, panel.height) - Vec2d(view->pixel_offset);
    return RenderedViews{{LayoutKind::kStack, {1, 1}, {}},
                         ViewCameras{view->distance_mm, Vec2d(panel.pixel_pitch_mm), centre, {Vec2d(0.0)}}};
  }
  const Vec2i n = whole_pixels_per_lens(optics);
  if (n.x < 1 || n.y < 1) return std::nullopt;
  const ViewLayout film{LayoutKind::kIntegral, {n.x, n.y}, {}};
  if (const auto* sheet = std::get_if<LenticularSheet>(&optics.model))
    return RenderedViews{film, lens_cameras(panel, *sheet, n)};
  if (const auto* array = std::get_if<MicrolensArray>(&optics.model))
    return RenderedViews{film, lens_cameras(panel, *array, n)};
  return std::nullopt;
}

std::optional<double> common_baseline_mm(const ViewCameras& cameras, ViewGrid grid) {
  constexpr double kShare = 1e-4;  // a hundredth of what disparities of 100 pixels would show
  const auto eye = [&](int column, int row) { return cameras.eyes_mm[static_cast<std::size_t>(row * grid.columns + column)]; };
  const double baseline = grid.columns > 1 ? eye(1, 0).x - eye(0, 0).x : grid.rows > 1 ? eye(0, 1).y - eye(0, 0).y : 0.0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2d miss = eye(column, row) - eye(0, 0) - baseline * Vec2d(column, row);
      if (std::max(std::abs(miss.x), std::abs(miss.y)) > kShare * std::abs(baseline)) return std::nullopt;
    }
  return baseline;
}

}  // namespace lippmann

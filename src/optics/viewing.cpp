#include "lippmann/optics/viewing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lippmann {
namespace {

/// What windows and zones of lens arrays are made of.
struct LensNumbers {
  double pitch, row_pitch, gap, viewing_distance, eye_height;  ///< mm; pitch: along x
  double cell;                                                 ///< mm on the panel, along x
};

LensNumbers numbers_of(const LenticularSheet& s) {
  const double spread = 1.0 + s.gap_mm / double(s.viewing_distance_mm);
  const double pitch = s.lens_pitch_mm / std::cos(double(s.slant));
  return {pitch, 0.0, s.gap_mm, s.viewing_distance_mm, s.eye_height_mm, pitch * spread};
}

LensNumbers numbers_of(const MicrolensArray& a) {
  const double spread = 1.0 + a.gap_mm / double(a.viewing_distance_mm);
  const double rows = a.packing == LensPacking::kHexagonal ? std::sqrt(0.75) : 1.0;
  return {a.lens_pitch_mm, a.lens_pitch_mm * rows, a.gap_mm, a.viewing_distance_mm, 0.0, a.lens_pitch_mm * spread};
}

std::optional<LensNumbers> lenses_of(const Optics& optics) {
  if (const auto* sheet = std::get_if<LenticularSheet>(&optics.model)) return numbers_of(*sheet);
  if (const auto* array = std::get_if<MicrolensArray>(&optics.model)) return numbers_of(*array);
  return std::nullopt;
}

Vec2i tiles_of(const Optics& optics) {
  const auto* views = std::get_if<MultiView>(&optics.model);
  return views ? Vec2i(views->columns, views->rows) : Vec2i(1);
}

const MultiView* camera_grid(const Optics& optics) {
  const auto* views = std::get_if<MultiView>(&optics.model);
  return views && views->baseline_mm > 0.0f ? views : nullptr;
}

double distance_of_views(const Optics& optics) {
  if (const auto* views = std::get_if<MultiView>(&optics.model)) return views->distance_mm;
  if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model)) return slanted->distance_mm;
  return std::get<SingleView>(optics.model).distance_mm;
}

/// How much of its slope per mm of z an eye has that far through the zone, seen from the middle of the display.
double zone_slope(const Optics& optics, double share) {
  if (const auto lenses = lenses_of(optics)) return (share - 0.5) * lenses->cell / lenses->gap;
  if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model)) return std::tan(slanted->view_cone * (share - 0.5));
  const auto* views = std::get_if<MultiView>(&optics.model);
  if (!views) return 0.0;
  if (views->baseline_mm > 0.0f) return (share - 0.5) * views->columns * views->baseline_mm / views->distance_mm;
  const int count = views->columns * views->rows;
  // The ends of the cone are views' eyes where they are included: the zone then reaches half a view farther.
  const double widening = views->cone_ends_included && count > 1 ? count / (count - 1.0) : 1.0;
  return std::tan(views->view_cone * widening * (share - 0.5));
}

/// A whole number of samples: at least one, and not more than a panel's side can have.
int rounded(double samples) { return static_cast<int>(std::clamp(std::round(samples), 1.0, 65536.0)); }
int rounded_up(double samples) { return rounded(std::ceil(samples - 0.01)); }

}  // namespace

Window display_window(const Optics& optics) {
  const double m = optics.panel.pixel_pitch_mm;
  const Vec2d panel(optics.panel.width / tiles_of(optics).x * m, optics.panel.height / tiles_of(optics).y * m);
  if (const auto lenses = lenses_of(optics)) {
    const double toward_viewer = lenses->gap / (lenses->viewing_distance + lenses->gap);  // 0 where that is infinite
    return {{0.0, lenses->eye_height * toward_viewer}, panel * (1.0 - toward_viewer)};
  }
  if (const auto* view = std::get_if<SingleView>(&optics.model))
    return {Vec2d(view->pixel_offset.x, -view->pixel_offset.y) * m, panel};
  return {{0.0, 0.0}, Vec2d(window_size_mm(optics))};
}

Viewer design_viewer(const Optics& optics) {
  const auto lenses = lenses_of(optics);
  if (!lenses) return viewer_at({0.0, 0.0, distance_of_views(optics)});
  if (std::isinf(lenses->viewing_distance)) return {};
  return viewer_at({0.0, lenses->eye_height, lenses->viewing_distance});
}

Viewer viewer_in_zone(const Optics& optics, double share) {
  Viewer viewer = design_viewer(optics);
  viewer.slope_at_centre.x += zone_slope(optics, share);
  return viewer;
}

Viewer viewer_in_zone_vertically(const Optics& optics, double share) {
  Viewer viewer = design_viewer(optics);
  if (std::holds_alternative<MicrolensArray>(optics.model)) {
    const LensNumbers lenses = *lenses_of(optics);
    viewer.slope_at_centre.y += (share - 0.5) * lenses.cell * (lenses.row_pitch / lenses.pitch) / lenses.gap;
  }
  if (const MultiView* grid = camera_grid(optics))
    viewer.slope_at_centre.y += (share - 0.5) * grid->rows * grid->baseline_mm / grid->distance_mm;
  return viewer;
}

double zone_x_mm(const Optics& optics, double share, double z_mm) { return zone_slope(optics, share) * z_mm; }

Vec3d default_eye_mm(const Optics& optics) {
  const Viewer viewer = design_viewer(optics);
  if (viewer.vergence > 0.0) return {viewer.slope_at_centre / viewer.vergence, 1.0 / viewer.vergence};
  return {0.0, 0.0, 3.0 * display_window(optics).size.y};
}

Vec2i lens_grid(const Optics& optics) {
  const Vec2i pixels = picture_size(optics) / tiles_of(optics);
  const Vec2d window = display_window(optics).size;
  const auto lenses = lenses_of(optics);
  if (!lenses) return pixels;
  if (std::holds_alternative<LenticularSheet>(optics.model)) return {rounded(window.x / lenses->pitch), pixels.y};
  return {rounded(window.x / lenses->pitch), rounded(window.y / lenses->row_pitch)};
}

Vec2d sample_spacing_mm(const Optics& optics) {
  const auto lenses = lenses_of(optics);
  if (std::holds_alternative<MicrolensArray>(optics.model)) return {lenses->pitch, lenses->row_pitch};
  const Vec2d by_pixel = display_window(optics).size / Vec2d(picture_size(optics) / tiles_of(optics));
  if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model))
    return {display_window(optics).size.x / std::abs(slanted->periods), by_pixel.y};
  return lenses ? Vec2d(lenses->pitch, by_pixel.y) : by_pixel;
}

Parallax parallax_of(const Optics& optics) {
  if (const MultiView* grid = camera_grid(optics)) return {grid->columns > 1, grid->rows > 1};
  return {!std::holds_alternative<SingleView>(optics.model), std::holds_alternative<MicrolensArray>(optics.model)};
}

Vec2i view_counts(const Optics& optics) {
  if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model))
    return {rounded_up(optics.panel.width / std::abs(slanted->periods)), 1};
  const auto lenses = lenses_of(optics);
  if (camera_grid(optics)) return tiles_of(optics);
  if (!lenses) return {tiles_of(optics).x * tiles_of(optics).y, 1};
  const auto pixels = [&](double cell) { return rounded_up(cell / optics.panel.pixel_pitch_mm); };
  if (std::holds_alternative<LenticularSheet>(optics.model)) return {pixels(lenses->cell), 1};
  return {pixels(lenses->cell), pixels(lenses->cell * (lenses->row_pitch / lenses->pitch))};
}

Vec2i natural_view_size(const Optics& optics) {
  const Vec2i grid = lens_grid(optics);
  const Vec2d window = display_window(optics).size;
  const double pixel = std::min(window.x / grid.x, window.y / grid.y);
  return {rounded(window.x / pixel), rounded(window.y / pixel)};
}

Optics pinhole_through_window(const Window& window, Vec2i size, Vec3d eye_mm) {
  const double pixel = window.size.x / size.x;
  const Vec2d offset = (window.centre - Vec2d(eye_mm)) / pixel;
  Optics optics;
  optics.panel = {size.x, size.y, static_cast<float>(pixel)};
  optics.model = SingleView{static_cast<float>(eye_mm.z), Vec2f(offset.x, -offset.y)};
  return optics;
}

}  // namespace lippmann

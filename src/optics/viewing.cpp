#include "lippmann/optics/viewing.hpp"

#include <algorithm>
#include <cmath>

#include "optics/models.hpp"

namespace lippmann {
namespace {

/// Returns the slope (right, up) of the direction to an eye, relative to the middle of the viewing zone. `share` is the
/// position in the zone, from 0 to 1 on each axis.
Vec2d slope_in_zone(const Optics& optics, Vec2d share) {
  return std::visit([&](const auto& model) { return zone_slope(optics.panel, model, share); }, optics.model);
}

Vec2i window_pixels(const Optics& optics, const OpticsFacts& facts) {
  return facts.tiles ? picture_size(optics) / Vec2i(facts.tiles->columns, facts.tiles->rows) : picture_size(optics);
}

}  // namespace

Window display_window(const Optics& optics) { return optics_facts(optics).window; }

Viewer design_viewer(const Optics& optics) {
  const OpticsFacts facts = optics_facts(optics);
  if (std::isinf(facts.viewing_distance_mm)) return {};
  return viewer_at({0.0, facts.eye_height_mm, facts.viewing_distance_mm});
}

Viewer viewer_in_zone(const Optics& optics, double share) {
  Viewer viewer = design_viewer(optics);
  viewer.slope_at_centre.x += slope_in_zone(optics, {share, 0.5}).x;
  return viewer;
}

Viewer viewer_in_zone_vertically(const Optics& optics, double share) {
  Viewer viewer = design_viewer(optics);
  viewer.slope_at_centre.y += slope_in_zone(optics, {0.5, share}).y;
  return viewer;
}

double zone_x_mm(const Optics& optics, double share, double z_mm) { return slope_in_zone(optics, {share, 0.5}).x * z_mm; }

Vec3d default_eye_mm(const Optics& optics) {
  const Viewer viewer = design_viewer(optics);
  if (viewer.vergence > 0.0) return {viewer.slope_at_centre / viewer.vergence, 1.0 / viewer.vergence};
  return {0.0, 0.0, 3.0 * display_window(optics).size.y};
}

Vec2i lens_grid(const Optics& optics) {
  const OpticsFacts facts = optics_facts(optics);
  Vec2i grid = window_pixels(optics, facts);
  if (!facts.lenses) return grid;
  grid.x = rounded_count(facts.window.size.x / facts.lenses->pitch_mm);
  if (facts.lenses->row_pitch_mm > 0.0) grid.y = rounded_count(facts.window.size.y / facts.lenses->row_pitch_mm);
  return grid;
}

Vec2d sample_spacing_mm(const Optics& optics) {
  const OpticsFacts facts = optics_facts(optics);
  Vec2d spacing = facts.window.size / Vec2d(window_pixels(optics, facts));
  if (facts.lens_step_mm > 0.0) spacing.x = facts.lens_step_mm;
  if (facts.lenses && facts.lenses->row_pitch_mm > 0.0) spacing.y = facts.lenses->row_pitch_mm;
  return spacing;
}

Parallax parallax_of(const Optics& optics) { return optics_facts(optics).parallax; }

Vec2i view_counts(const Optics& optics) { return optics_facts(optics).view_counts; }

std::optional<ViewPhases> view_phases(const Optics& optics) {
  return std::visit(
      []<class Model>(const Model& model) -> std::optional<ViewPhases> {
        if constexpr (HasViewPhases<Model>)
          return view_phases_of(model);
        else
          return std::nullopt;
      },
      optics.model);
}

Vec2i natural_view_size(const Optics& optics) {
  const Vec2i grid = lens_grid(optics);
  const Vec2d window = display_window(optics).size;
  const double pixel = std::min(window.x / grid.x, window.y / grid.y);
  return {rounded_count(window.x / pixel), rounded_count(window.y / pixel)};
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

#include "optics/sight.hpp"

#include <cmath>

namespace lippmann {
namespace {

/// Returns the panel coordinate s (lens_axis.hpp), in pixels, where a line through the centre of a lens meets the panel.
/// `lens`: index of the lens, plus 1/2 in odd rows of a hexagonal array.
double panel_px(const LensAxis<double>& axis, double lens, double slope) {
  const double lens_mm = axis.lens0_mm + lens * axis.pitch_mm;
  const double offset = -(slope + (lens_mm - axis.eye_mm) * axis.vergence) / axis.slope_per_px;
  return axis.start_px + (lens + 0.5) * axis.cell_px + offset;
}

}  // namespace

PanelPoint LenticularSight::seen_from(const Viewer& viewer, Vec2d point_mm) const {
  const Vec2d across(c_.cosine, c_.sine), along(-c_.sine, c_.cosine);
  const double lens = lens_at(c_.axis, glm::dot(point_mm, across));
  const double eta = glm::dot(point_mm, along);
  const double xi = c_.axis.lens0_mm + lens * c_.axis.pitch_mm;
  const Vec2d slope = viewer.slope_at(xi * across + eta * along);
  const double s = panel_px(c_.axis, lens, glm::dot(slope, across));
  const double xi_panel = xi - c_.gap_mm * glm::dot(slope, across), eta_panel = eta - c_.gap_mm * glm::dot(slope, along);
  const double py = c_.half_height_px - (xi_panel * c_.sine + eta_panel * c_.cosine) / c_.pixel_pitch_mm;
  return {{(s + py * c_.sine) * c_.inverse_cosine, py}, {lens, 0.0}};
}

PanelPoint MicrolensSight::seen_from(const Viewer& viewer, Vec2d point_mm) const {
  const double x = point_mm.x, down = -point_mm.y;
  Vec2d lens(lens_at(c_.columns, x), lens_at(c_.rows, down));
  if (hexagonal_) {
    const HexagonalCell<double> nearest =
        nearest_hexagon((x - c_.columns.lens0_mm) / c_.columns.pitch_mm, (down - c_.rows.lens0_mm) / c_.rows.pitch_mm);
    lens = {nearest.column, nearest.row};
  }
  const Vec2d centre(c_.columns.lens0_mm + lens.x * c_.columns.pitch_mm, -(c_.rows.lens0_mm + lens.y * c_.rows.pitch_mm));
  const Vec2d slope = viewer.slope_at(centre);
  return {{panel_px(c_.columns, lens.x, slope.x), panel_px(c_.rows, lens.y, -slope.y)}, lens};
}

CellOf MicrolensSight::cell(Vec2d pixel) const {
  if (!hexagonal_) return {cell_of(c_.columns, pixel.x), cell_of(c_.rows, pixel.y)};
  const HexagonalCell<double> cell = hexagon_at(c_, pixel.x, pixel.y);
  return {cell.column, cell.row};
}

LenticularSight sight_of(const Panel& panel, const LenticularSheet& sheet) { return {panel, sheet}; }
MicrolensSight sight_of(const Panel& panel, const MicrolensArray& array) { return {panel, array}; }
QuiltSight sight_of(const Panel& panel, const MultiView& views) { return {panel, views}; }
QuiltSight sight_of(const Panel& panel, const SingleView& view) { return {panel, view}; }

QuiltSight::QuiltSight(const Panel& panel, const MultiView& views)
    : columns_(views.columns),
      panel_height_(panel.height),
      tile_(panel.width / views.columns, panel.height / views.rows),
      centre_px_(0.5 * Vec2d(tile_)),
      pixel_mm_(Vec2d(1.0, views.pixel_height) * double(panel.pixel_pitch_mm)),
      distance_(views.distance_mm),
      baseline_(views.baseline_mm) {
  views_ = baseline_ > 0.0 ? Vec2i(views.columns, views.rows) : Vec2i(views.columns * views.rows, 1);
  if (baseline_ > 0.0) return;
  const double count = views_.x, cone = views.view_cone;
  const bool ends = views.cone_ends_included;
  angle_step_ = count > 1 ? cone / (ends ? count - 1 : count) : 0.0;
  first_angle_ = -0.5 * angle_step_ * (count - 1);
}

QuiltSight::QuiltSight(const Panel& panel, const SingleView& view)
    : panel_height_(panel.height),
      tile_(panel.width, panel.height),
      centre_px_(0.5 * Vec2d(tile_) - Vec2d(view.pixel_offset)),
      pixel_mm_(panel.pixel_pitch_mm),
      distance_(view.distance_mm) {}

QuiltPoint QuiltSight::seen_from(const Viewer& viewer, Vec2d point_mm) const {
  QuiltPoint seen;
  seen.pixel = centre_px_ + Vec2d(point_mm.x, -point_mm.y) / pixel_mm_;
  if (baseline_ > 0.0) {
    const Vec2d at_views = point_mm + distance_ * viewer.slope_at(point_mm), last(views_ - 1);
    seen.view = at_views / baseline_ + 0.5 * last;
    const Vec2d nearest = glm::clamp(seen.view, Vec2d(-0.5), last + 0.5);
    seen.in_zone = nearest == seen.view;
    seen.view = glm::clamp(nearest, Vec2d(0.0), last);
    return seen;
  }
  if (angle_step_ == 0.0) return seen;
  const double x_at_views = point_mm.x + distance_ * viewer.slope_at(point_mm).x;
  const double view = (std::atan(x_at_views / distance_) - first_angle_) / angle_step_, count = views_.x;
  const double zone = std::floor((view + 0.5) / count);
  seen.view.x = view - count * zone;
  seen.in_zone = zone == 0.0;
  return seen;
}

Vec2i QuiltSight::tile_origin(Vec2i view) const {
  const int tile = view.y * views_.x + view.x;
  return {tile % columns_ * tile_.x, panel_height_ - (tile / columns_ + 1) * tile_.y};
}

}  // namespace lippmann

#include "view/view_axes.hpp"

#include <cmath>

#include "lippmann/optics/viewing.hpp"
#include "optics/model.hpp"

namespace lippmann {
namespace {

ViewAxis axis_between(int count, double first_slope, double last_slope, bool by_angle, BeyondZone beyond) {
  const auto placed = [&](double slope) { return by_angle ? std::atan(slope) : slope; };
  ViewAxis axis{count, placed(first_slope), 0.0, by_angle, beyond};
  if (count > 1) axis.step = (placed(last_slope) - axis.first) / (count - 1);
  return axis;
}

BeyondZone beyond_zone(const OpticsFacts& facts) {
  if (facts.lenses) return BeyondZone::kNextLens;
  return facts.views_by_angle ? BeyondZone::kRepeats : BeyondZone::kStays;
}

}  // namespace

double ViewAxis::slope(double view) const {
  const double placed = first + view * step;
  return by_angle ? std::tan(placed) : placed;
}

ViewAxes view_axes(const Optics& optics, ViewGrid grid) {
  const auto first = [](int count) { return 0.5 / count; };
  const auto last = [](int count) { return 1.0 - 0.5 / count; };
  const auto across = [&](double share) { return viewer_in_zone(optics, share).slope_at_centre.x; };
  const auto up = [&](double share) { return viewer_in_zone_vertically(optics, share).slope_at_centre.y; };
  const OpticsFacts facts = optics_facts(optics);
  ViewAxes axes;
  axes.across = axis_between(grid.columns, across(first(grid.columns)), across(last(grid.columns)), facts.views_by_angle,
                             beyond_zone(facts));
  axes.up = axis_between(grid.rows, up(first(grid.rows)), up(last(grid.rows)), false,
                         grid.rows > 1 ? beyond_zone(facts) : BeyondZone::kStays);
  axes.vergence = design_viewer(optics).vergence;
  return axes;
}

}  // namespace lippmann

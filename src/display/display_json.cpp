#include "display/display_json.hpp"

#include <nlohmann/json.hpp>

namespace lippmann {
namespace {

using OrderedJson = nlohmann::ordered_json;

const char* to_string(Calibration::Flip flip) {
  switch (flip) {
    case Calibration::Flip::kSlope:
      return "slope";
    case Calibration::Flip::kSlopeStepAndCenter:
      return "slope-step-and-center";
    case Calibration::Flip::kSlopeAndStep:
      break;
  }
  return "slope-and-step";
}

OrderedJson calibration_json(const Calibration& c) {
  OrderedJson json{{"pitch", c.pitch},
                   {"slope", c.slope},
                   {"center", c.center},
                   {"invView", c.invert},
                   {"flipImageX", c.flip_image_x},
                   {"flipImageY", c.flip_image_y},
                   {"flipSubp", c.flip_sub_pixels},
                   {"verticalAngle", c.vertical_angle_deg},
                   {"fringe", c.fringe},
                   {"CellPatternMode", c.cell_pattern},
                   {"patterns", c.patterns == Calibration::Patterns::kColumns ? "columns" : "rows"},
                   {"inversion", c.inversion == Calibration::Inversion::kAlways ? "always" : "if-flagged"},
                   {"flip", to_string(c.flip)}};
  json["subpixelCells"] = OrderedJson::array();
  for (const SubPixelCell& cell : c.cells)
    json["subpixelCells"].push_back({{"ROffsetX", cell[0].x},
                                     {"ROffsetY", cell[0].y},
                                     {"GOffsetX", cell[1].x},
                                     {"GOffsetY", cell[1].y},
                                     {"BOffsetX", cell[2].x},
                                     {"BOffsetY", cell[2].y}});
  return json;
}

OrderedJson lenses_json(const DisplayLenses& lenses) {
  OrderedJson json{{"pitch_mm", lenses.pitch_mm},
                   {"lenses_per_inch", 25.4 / lenses.pitch_mm},
                   {"slant_deg", lenses.slant_deg},
                   {"packing", lenses.packing == LensPacking::kSquare ? "square" : "hexagonal"}};
  if (lenses.phase_px) json["phase_px"] = *lenses.phase_px;
  return json;
}

}  // namespace

OrderedJson display_json(const Display& d) {
  OrderedJson json{{"name", d.name},
                   {"description", d.description},
                   {"kind", to_string(d.kind)},
                   {"serials", d.serials},
                   {"pixels", {d.pixels.x, d.pixels.y}},
                   {"dpi", d.dpi},
                   {"size_mm", {d.size_mm().x, d.size_mm().y}},
                   {"views", views_of(d)},
                   {"view_cone_deg", d.view_cone_deg},
                   {"viewing_distance_mm", viewing_distance_mm(d)},
                   {"depth_budget_mm", depth_budget_mm(native_optics(d))}};
  if (d.kind == DisplayKind::kSlantedPanel) {
    json["calibration"] = calibration_json(d.calibration);
    json["periods"] = periods_of(d);
    json["tilt"] = tilt_of(d);
  } else {
    json["lenses"] = lenses_json(d.lenses);
  }
  if (d.crosstalk_px) json["crosstalk_px"] = *d.crosstalk_px;
  if (const std::optional<Optics> quilt = quilt_optics(d))
    json["quilt"] = {{"tiles", {d.quilt->columns, d.quilt->rows}},
                     {"size", {d.quilt->width, d.quilt->height}},
                     {"aspect", d.quilt->aspect},
                     {"depth_budget_mm", depth_budget_mm(*quilt)}};
  json["video"] = {{"codec", d.video.codec}, {"longest_side", d.video.longest_side}, {"quilts", d.video.quilts}};
  return json;
}

}  // namespace lippmann

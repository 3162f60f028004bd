#include "optics/lenticular.hpp"

#include "core/degrees.hpp"
#include "core/json_fields.hpp"
#include "optics/checks.hpp"
#include "optics/lens_params.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {

LenticularConstants<double> make_lenticular(const Panel& panel, const LenticularSheet& sheet, double z_front_mm) {
  const double m = panel.pixel_pitch_mm, gap = sheet.gap_mm, distance = sheet.viewing_distance_mm, slant = sheet.slant;
  LenticularConstants<double> c{};
  c.half_height_px = 0.5 * panel.height;
  c.pixel_pitch_mm = m, c.gap_mm = gap;
  c.cosine = std::cos(slant), c.sine = std::sin(slant), c.inverse_cosine = 1.0 / c.cosine;
  c.eye_y_mm = sheet.eye_height_mm;
  c.row_vergence = 1.0 / (distance + gap);
  c.z_front_mm = z_front_mm;
  // This form of the equation makes all rows meet exactly at the eye if z_front is the viewing distance.
  c.row_scale = std::isinf(distance) ? 1.0 : (distance - z_front_mm) * c.row_vergence;
  c.row_shift_mm = c.eye_y_mm * (z_front_mm + gap) * c.row_vergence;
  c.axis = make_lens_axis({.pitch_mm = sheet.lens_pitch_mm,
                           .offset_mm = sheet.offset_mm,
                           .gap_mm = gap,
                           .viewing_distance_mm = distance,
                           .eye_mm = c.eye_y_mm * c.sine,
                           .pixel_pitch_mm = m,
                           .centre_px = 0.5 * panel.width * c.cosine - c.half_height_px * c.sine,
                           .size_px = slant == 0.0 ? panel.width : 0,
                           .parallax = sheet.parallax});
  return c;
}

LIPPMANN_MULTIVERSION
void write_block(const LenticularRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

namespace {

void append_row_of_cell(const LenticularConstants<double>& c, int width, double xi_mm, double py, std::vector<Vec2f>& pixels) {
  const double row = std::floor(py) + 0.5;
  const double lens = lens_at(c.axis, xi_mm);
  const double first = (c.axis.start_px + lens * c.axis.cell_px + row * c.sine) * c.inverse_cosine;
  const double last = first + c.axis.cell_px * c.inverse_cosine;
  const int begin = static_cast<int>(std::clamp(std::floor(first), 0.0, 1.0 * width));
  const int end = static_cast<int>(std::clamp(std::ceil(last), 0.0, 1.0 * width));
  for (int i = begin; i < end; ++i)
    if (cell_of(c.axis, (i + 0.5) * c.cosine - row * c.sine) == lens) pixels.emplace_back(i + 0.5, row);
}

}  // namespace

void pixels_seeing(const Panel& panel, const LenticularSheet& sheet, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const LenticularConstants<double> c = make_lenticular(panel, sheet, 0.0);
  const double x = point_mm.x, y = point_mm.y, z = point_mm.z, xi = x * c.cosine + y * c.sine;
  // Solves y_panel + (z + g) (y_e - y_panel) / (V + g) = y for y_panel, the y of the panel row that sees the point. g is the
  // gap, V the viewing distance and y_e the height of the eye.
  const double toward_eye = (z + c.gap_mm) * c.row_vergence;
  const double py = c.half_height_px - (y - c.eye_y_mm * toward_eye) / (1.0 - toward_eye) / c.pixel_pitch_mm;
  if (!(py >= 0.0 && py < panel.height)) return;
  if (in_lens_plane(c.axis, z)) return append_row_of_cell(c, panel.width, xi, py, pixels);

  const double left = -py * c.sine, right = left + panel.width * c.cosine, half_cell = 0.5 * c.axis.cell_px;
  const LensRange range = lenses_near(c.axis, xi, z, half_cell, left, right);
  for (int k = range.first; k <= range.last; ++k) {
    const double offset = image_offset_px(c.axis, c.axis.lens0_mm + k * c.axis.pitch_mm, xi, z);
    if (!(offset >= -half_cell && offset < half_cell)) continue;
    const double s = c.axis.start_px + (k + 0.5) * c.axis.cell_px + offset;
    const double px = (s + py * c.sine) * c.inverse_cosine;
    if (px >= 0.0 && px < panel.width) pixels.emplace_back(px, py);
  }
}

void check_model(const Panel& panel, const LenticularSheet& sheet) {
  check_lens("lenticular.lens_pitch_mm", sheet.lens_pitch_mm, panel);
  check_length("lenticular.gap_mm", sheet.gap_mm);
  if (!(std::abs(sheet.slant) < radians(89.9f)))
    reject_field("lenticular.slant", fmt::format("is {} degrees", degrees(sheet.slant)),
                 "an angle between -89.9 and 89.9 degrees");
  check_position("lenticular.offset_mm", sheet.offset_mm);
  check_distance_or_infinity("lenticular.viewing_distance_mm", sheet.viewing_distance_mm);
  check_position("lenticular.eye_height_mm", sheet.eye_height_mm);
  check_parallax("lenticular.parallax", sheet.parallax);
}

void write_model(const LenticularSheet& sheet, nlohmann::ordered_json& json) {
  json["lens_pitch_mm"] = sheet.lens_pitch_mm;
  json["gap_mm"] = sheet.gap_mm;
  json["slant_deg"] = to_degrees(sheet.slant);
  json["offset_mm"] = sheet.offset_mm;
  json["viewing_distance_mm"] = finite_or_null(sheet.viewing_distance_mm);
  json["eye_height_mm"] = sheet.eye_height_mm;
}

void read_model(const JsonFields& json, LenticularSheet& sheet) {
  json.require({"lens_pitch_mm", "gap_mm", "slant_deg", "viewing_distance_mm"});
  sheet.lens_pitch_mm = json.float_number("lens_pitch_mm");
  sheet.gap_mm = json.float_number("gap_mm");
  sheet.slant = from_degrees(json.number("slant_deg"));
  sheet.offset_mm = json.float_or("offset_mm", sheet.offset_mm);
  sheet.viewing_distance_mm = json.float_or_infinity("viewing_distance_mm");
  sheet.eye_height_mm = json.float_or("eye_height_mm", 0.0f);
}

OpticsFacts facts_of(const Panel& panel, const LenticularSheet& sheet) {
  const double cosine = std::cos(static_cast<double>(sheet.slant)), pitch = sheet.lens_pitch_mm / cosine;
  const double spread = 1.0 + sheet.gap_mm / static_cast<double>(sheet.viewing_distance_mm);
  const int whole = make_lenticular(panel, sheet, 0.0).axis.whole_pixels;
  OpticsFacts facts = facts_of_lenses(
      panel,
      {pitch, 0.0, sheet.gap_mm, sheet.viewing_distance_mm, sheet.eye_height_mm, pitch * spread, cosine, sheet.lens_pitch_mm},
      whole > 0 ? Vec2i(whole, 1) : Vec2i(0));
  const double viewer = sheet.viewing_distance_mm;
  // Scale from the panel to z = 0, where rows are closer, because their rays converge to the viewer.
  const double to_plane = std::isfinite(viewer) ? viewer / (viewer + sheet.gap_mm) : 1.0;
  facts.samples = {pitch, panel.pixel_pitch_mm * to_plane};
  facts.crosstalk_pitch = {cosine, 0.0};
  return facts;
}

Vec2d zone_slope(const Panel&, const LenticularSheet& sheet, Vec2d share) {
  const double pitch = sheet.lens_pitch_mm / std::cos(static_cast<double>(sheet.slant));
  const double cell = pitch * (1.0 + sheet.gap_mm / static_cast<double>(sheet.viewing_distance_mm));
  return {(share.x - 0.5) * cell / sheet.gap_mm, 0.0};
}

StepRule step_rule(const Panel& panel, const LenticularSheet& sheet, StepsWithin within) {
  const LenticularRays c = make_lenticular(panel, sheet, 0.0).as<float>();
  StepRule rule;
  if (within == StepsWithin::kLens)
    rule.bounds = StepRule::Bounds::kSheetLens;
  else
    rule.across.x = c.axis.cell_px * c.inverse_cosine;
  rule.down.x = c.sine * c.inverse_cosine;  // a step down follows the slant of the lens
  rule.columns = c.axis, rule.cosine = c.cosine, rule.sine = c.sine, rule.inverse_cosine = c.inverse_cosine;
  return rule;
}

std::optional<ViewCameras> cameras_of(const Panel& panel, const LenticularSheet& sheet) {
  const int n = make_lenticular(panel, sheet, 0.0).axis.whole_pixels;
  const double v = sheet.viewing_distance_mm, g = sheet.gap_mm, m = panel.pixel_pitch_mm;
  if (n < 1 || !std::isfinite(v)) return std::nullopt;
  // The rays of all pixel rows converge to the eye, so raising the eye moves their intersections with the lens plane upwards.
  const Vec2d centre(0.5 * panel.width / n, 0.5 * panel.height + g * sheet.eye_height_mm / (v * m));
  return ViewCameras{
      v, {sheet.lens_pitch_mm, m * v / (v + g)}, centre, lens_eyes({n, 1}, sheet.parallax * m * v / g, sheet.eye_height_mm)};
}

LensCells lens_cells_of(const Panel& panel, const LenticularSheet& sheet) {
  const double slant = sheet.slant, pitch = sheet.lens_pitch_mm, pixel = panel.pixel_pitch_mm;
  const double spread = 1.0 + sheet.gap_mm / static_cast<double>(sheet.viewing_distance_mm);
  LensCells cells;
  cells.lenses_per_mm = Vec2d(std::cos(slant), std::sin(slant)) / pitch;
  cells.first_lens = sheet.offset_mm / pitch;
  cells.cell_px.x = pitch / std::cos(slant) * spread / pixel;
  cells.px_per_k.x = sheet.gap_mm / (pixel * sheet.parallax);
  return cells;
}

void set_lenses(LenticularSheet& sheet, float pitch_mm, float gap_mm, Vec2f offset_mm) {
  sheet.lens_pitch_mm = pitch_mm, sheet.gap_mm = gap_mm, sheet.offset_mm = offset_mm.x;
  sheet.viewing_distance_mm = kInfinity;
}

namespace {

PanelSize lenticular_size(const OpticsParams& params, Vec2i) {
  const float pixels = lens_pixels_across(params);
  if (params.size.x > 0) return {params.size.x, params.size.y, pixels};
  const int lenses = params.lenses.x > 0 ? params.lenses.x : kDefaultLenses;
  return {covered_pixels(lenses, pixels),
          covered_pixels(params.lenses.y > 0 ? params.lenses.y : lenses,
                         params.lens_pixels.y > 0.0f ? params.lens_pixels.y : pixels),
          pixels};
}

OpticsModel sheet_of_params(const ModelSetup& setup) {
  const Panel& panel = setup.panel;
  LenticularSheet sheet;
  sheet.slant = radians(setup.params.slant_deg);
  const float cell =  // the cosine is needed because `lens_pixels` counts pixels along a row
      setup.size.lens_pixels * panel.pixel_pitch_mm * std::cos(sheet.slant);
  const LensGeometry lens = lens_geometry(cell, setup.params, setup.viewing_distance_mm);
  const float width = static_cast<float>(panel.width) * panel.pixel_pitch_mm * std::cos(sheet.slant);
  sheet.lens_pitch_mm = lens.pitch_mm;
  sheet.gap_mm = lens.gap_mm;
  sheet.offset_mm = cell_center_nearest_middle(width, cell) * lens.pitch_per_cell;
  sheet.viewing_distance_mm = setup.viewing_distance_mm;
  return sheet;
}

}  // namespace

constinit const OpticsKindInfo lenticular_kind{.name = kind_of(LenticularSheet{}),
                                               .takes = {"lenses", "lens-pixels", "slant"},
                                               .panel_size = lenticular_size,
                                               .make_model = sheet_of_params};

const OpticsKindInfo& kind_info(const LenticularSheet&) { return lenticular_kind; }

}  // namespace lippmann

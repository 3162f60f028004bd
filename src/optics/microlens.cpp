#include "optics/microlens.hpp"

#include <numbers>

#include "core/json_fields.hpp"
#include "optics/checks.hpp"
#include "optics/lens_params.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {

MicrolensConstants<double> make_microlens(const Panel& panel, const MicrolensArray& array, double z_front_mm) {
  const bool hexagonal = array.packing == LensPacking::kHexagonal;
  const double pitch = array.lens_pitch_mm, row_pitch = hexagonal ? pitch * (0.5 * std::numbers::sqrt3) : pitch;
  LensAxisSpec columns{.pitch_mm = pitch,
                       .offset_mm = array.offset_mm.x,
                       .gap_mm = array.gap_mm,
                       .viewing_distance_mm = array.viewing_distance_mm,
                       .eye_mm = 0.0,
                       .pixel_pitch_mm = panel.pixel_pitch_mm,
                       .centre_px = 0.5 * panel.width,
                       .size_px = hexagonal ? 0 : panel.width,
                       .parallax = array.parallax};
  LensAxisSpec rows = columns;
  rows.pitch_mm = row_pitch, rows.offset_mm = -array.offset_mm.y;
  rows.centre_px = 0.5 * panel.height;
  rows.size_px = hexagonal ? 0 : panel.height;
  // make_lens_axis() renumbers rows so that the row nearest to the centre becomes row 0. If that row was odd, it is shifted by
  // half a pitch, so the offset of the columns includes this shift.
  const double renamed_rows = std::round(rows.offset_mm / row_pitch);
  if (hexagonal && std::fmod(renamed_rows, 2.0) != 0.0) columns.offset_mm += 0.5 * pitch;
  return {make_lens_axis(columns), make_lens_axis(rows), z_front_mm};
}

LIPPMANN_MULTIVERSION
void write_block(const SquareMicrolensRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

LIPPMANN_MULTIVERSION
void write_block(const HexagonalMicrolensRays& c, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

namespace {

struct Search {
  MicrolensConstants<double> c;
  double width, height;
  std::vector<Vec2f>& pixels;

  Vec2d panel_point(double column, double row, double dx = 0.0, double dy = 0.0) const {
    return {c.columns.start_px + (column + 0.5) * c.columns.cell_px + dx, c.rows.start_px + (row + 0.5) * c.rows.cell_px + dy};
  }
  double offset_x(double column, double x, double z) const {
    return image_offset_px(c.columns, c.columns.lens0_mm + column * c.columns.pitch_mm, x, z);
  }
  double offset_y(double row, double down, double z) const {
    return image_offset_px(c.rows, c.rows.lens0_mm + row * c.rows.pitch_mm, down, z);
  }

  void append_inside(Vec2d p) const {
    if (p.x >= 0.0 && p.x < width && p.y >= 0.0 && p.y < height) pixels.emplace_back(p);
  }

  /// Appends the centres (x, y) of all pixels within `reach` of p for which belongs(x, y) is true, row by row.
  template <class Belongs>
  void append_centres(Vec2d p, Vec2d reach, const Belongs& belongs) const {
    const auto bound = [](double at, double size) { return static_cast<int>(std::clamp(at, 0.0, size)); };
    for (int j = bound(p.y - reach.y - 1, height); j < bound(p.y + reach.y + 1, height); ++j)
      for (int i = bound(p.x - reach.x - 1, width); i < bound(p.x + reach.x + 1, width); ++i)
        if (belongs(i + 0.5, j + 0.5)) pixels.emplace_back(i + 0.5, j + 0.5);
  }
};

void append_square_cell(const Search& s, double x, double down) {
  const double column = lens_at(s.c.columns, x), row = lens_at(s.c.rows, down);
  const auto belongs = [&](double px, double py) { return cell_of(s.c.columns, px) == column && cell_of(s.c.rows, py) == row; };
  s.append_centres(s.panel_point(column, row), {0.5 * s.c.columns.cell_px, 0.5 * s.c.rows.cell_px}, belongs);
}

void append_square(const Search& s, double x, double down, double z) {
  const double half_x = 0.5 * s.c.columns.cell_px, half_y = 0.5 * s.c.rows.cell_px;
  const LensRange columns = lenses_near(s.c.columns, x, z, half_x, 0.0, s.width);
  const LensRange rows = lenses_near(s.c.rows, down, z, half_y, 0.0, s.height);
  for (int r = rows.first; r <= rows.last; ++r) {
    const double dy = s.offset_y(r, down, z);
    if (!(dy >= -half_y && dy < half_y)) continue;
    for (int k = columns.first; k <= columns.last; ++k) {
      const double dx = s.offset_x(k, x, z);
      if (dx >= -half_x && dx < half_x) s.append_inside(s.panel_point(k, r, dx, dy));
    }
  }
}

void append_hexagonal_cell(const Search& s, double x, double down) {
  const HexagonalCell<double> lens =
      nearest_hexagon((x - s.c.columns.lens0_mm) / s.c.columns.pitch_mm, (down - s.c.rows.lens0_mm) / s.c.rows.pitch_mm);
  const auto belongs = [&](double px, double py) {
    const HexagonalCell<double> cell = hexagon_at(s.c, px, py);
    return cell.row == lens.row && cell.column == lens.column;
  };
  s.append_centres(s.panel_point(lens.column, lens.row), {0.5 * s.c.columns.cell_px, s.c.rows.cell_px}, belongs);
}

/// Each lens images the point to a position p on the panel. Appends p if it lies in the lens's own cell, which extends half a
/// column step to each side and 2/3 of a row step up and down.
void append_hexagonal(const Search& s, double x, double down, double z) {
  const double step_x = s.c.columns.cell_px, step_y = s.c.rows.cell_px;
  const LensRange columns = lenses_near(s.c.columns, x, z, 0.5 * step_x, -step_x, s.width + step_x);
  const LensRange rows = lenses_near(s.c.rows, down, z, step_y * (2.0 / 3.0), -step_y, s.height + step_y);
  for (int r = rows.first; r <= rows.last; ++r) {
    const double dy = s.offset_y(r, down, z);
    for (int k = columns.first; k <= columns.last; ++k) {
      const double column = k + (r % 2 == 0 ? 0.0 : 0.5);
      const Vec2d p = s.panel_point(column, r, s.offset_x(column, x, z), dy);
      const HexagonalCell<double> cell = hexagon_at(s.c, p.x, p.y);
      if (cell.row == r && cell.column == column) s.append_inside(p);
    }
  }
}

}  // namespace

void pixels_seeing(const Panel& panel, const MicrolensArray& array, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const Search search{make_microlens(panel, array, 0.0), 1.0 * panel.width, 1.0 * panel.height, pixels};
  const double x = point_mm.x, down = -point_mm.y, z = point_mm.z;
  const bool hexagonal = array.packing == LensPacking::kHexagonal;
  if (in_lens_plane(search.c.columns, z))
    hexagonal ? append_hexagonal_cell(search, x, down) : append_square_cell(search, x, down);
  else
    hexagonal ? append_hexagonal(search, x, down, z) : append_square(search, x, down, z);
}

std::variant<SquareMicrolensRays, HexagonalMicrolensRays> make_rays(const Panel& panel, const MicrolensArray& array,
                                                                    float z_front_mm) {
  const MicrolensConstants<float> constants = make_microlens(panel, array, z_front_mm).as<float>();
  if (array.packing == LensPacking::kHexagonal) return HexagonalMicrolensRays{constants};
  return SquareMicrolensRays{constants};
}

void check_model(const Panel& panel, const MicrolensArray& array) {
  check_lens("microlens.lens_pitch_mm", array.lens_pitch_mm, panel);
  check_length("microlens.gap_mm", array.gap_mm);
  check_position("microlens.offset_mm.x", array.offset_mm.x);
  check_position("microlens.offset_mm.y", array.offset_mm.y);
  check_distance_or_infinity("microlens.viewing_distance_mm", array.viewing_distance_mm);
  check_parallax("microlens.parallax", array.parallax);
}

void write_model(const MicrolensArray& array, nlohmann::ordered_json& json) {
  json["packing"] = array.packing == LensPacking::kSquare ? "square" : "hexagonal";
  json["lens_pitch_mm"] = array.lens_pitch_mm;
  json["gap_mm"] = array.gap_mm;
  json["offset_mm"] = {array.offset_mm.x, array.offset_mm.y};
  json["viewing_distance_mm"] = finite_or_null(array.viewing_distance_mm);
}

void read_model(const JsonFields& json, MicrolensArray& array) {
  json.require({"packing", "lens_pitch_mm", "gap_mm", "viewing_distance_mm"});
  array.packing = json.word("packing", {"square", "hexagonal"}) == 0 ? LensPacking::kSquare : LensPacking::kHexagonal;
  array.lens_pitch_mm = json.float_number("lens_pitch_mm");
  array.gap_mm = json.float_number("gap_mm");
  if (json.has("offset_mm")) array.offset_mm = json.pair("offset_mm");
  array.viewing_distance_mm = json.float_or_infinity("viewing_distance_mm");
}

namespace {

double row_pitch_mm(const MicrolensArray& array) {
  return array.lens_pitch_mm * (array.packing == LensPacking::kHexagonal ? std::sqrt(0.75) : 1.0);
}

/// Returns the width of a cell on the panel: the lens pitch, projected from the viewer onto the panel.
double cell_mm(const MicrolensArray& array) {
  return array.lens_pitch_mm * (1.0 + array.gap_mm / static_cast<double>(array.viewing_distance_mm));
}

Vec2i whole_cells(const Panel& panel, const MicrolensArray& array) {
  const MicrolensConstants<double> c = make_microlens(panel, array, 0.0);
  const Vec2i n(c.columns.whole_pixels, c.rows.whole_pixels);
  return n.x > 0 && n.y > 0 ? n : Vec2i(0);
}

}  // namespace

OpticsFacts facts_of(const Panel& panel, const MicrolensArray& array) {
  OpticsFacts facts = facts_of_lenses(panel,
                                      {array.lens_pitch_mm, row_pitch_mm(array), array.gap_mm, array.viewing_distance_mm, 0.0,
                                       cell_mm(array), 1.0, array.lens_pitch_mm},
                                      whole_cells(panel, array));
  facts.samples = {array.lens_pitch_mm, row_pitch_mm(array)};
  facts.crosstalk_pitch = Vec2d(1.0);
  return facts;
}

Vec2d zone_slope(const Panel&, const MicrolensArray& array, Vec2d share) {
  const double cell = cell_mm(array);
  return {(share.x - 0.5) * cell / array.gap_mm,
          (share.y - 0.5) * cell * (row_pitch_mm(array) / array.lens_pitch_mm) / array.gap_mm};
}

StepRule step_rule(const Panel& panel, const MicrolensArray& array, StepsWithin within) {
  const MicrolensConstants<float> c = make_microlens(panel, array, 0.0).as<float>();
  const bool hexagonal = array.packing == LensPacking::kHexagonal;
  StepRule rule;
  rule.columns = c.columns, rule.rows = c.rows;
  if (within == StepsWithin::kLens) {
    rule.bounds = hexagonal ? StepRule::Bounds::kHexagon : StepRule::Bounds::kSquareLens;
  } else {
    rule.across.x = c.columns.cell_px;
    // In a hexagonal array, the lens straight below a lens is two rows down.
    rule.down.y = c.rows.cell_px * (hexagonal ? 2.0f : 1.0f);
  }
  return rule;
}

std::optional<ViewCameras> cameras_of(const Panel& panel, const MicrolensArray& array) {
  const Vec2i n = whole_cells(panel, array);
  const double v = array.viewing_distance_mm, g = array.gap_mm, m = panel.pixel_pitch_mm;
  if (n.x < 1 || !std::isfinite(v)) return std::nullopt;
  const Vec2d centre(0.5 * panel.width / n.x, 0.5 * panel.height / n.y);
  return ViewCameras{v, Vec2d(array.lens_pitch_mm), centre, lens_eyes(n, array.parallax * m * v / g, 0.0)};
}

LensCells lens_cells_of(const Panel& panel, const MicrolensArray& array) {
  const double pitch = array.lens_pitch_mm, row_pitch = row_pitch_mm(array), pixel = panel.pixel_pitch_mm;
  LensCells cells;
  cells.rows = array.packing == LensPacking::kHexagonal ? LensCells::Rows::kHexagonal : LensCells::Rows::kSquare;
  cells.lenses_per_mm.x = 1.0 / pitch, cells.first_lens = array.offset_mm.x / pitch;
  cells.rows_per_mm = 1.0 / row_pitch, cells.first_row_mm = array.offset_mm.y;
  cells.cell_px = Vec2d(1.0, row_pitch / pitch) * (cell_mm(array) / pixel);
  cells.px_per_k = Vec2d(array.gap_mm / (pixel * array.parallax));
  return cells;
}

void set_lenses(MicrolensArray& array, float pitch_mm, float gap_mm, Vec2f offset_mm) {
  array.lens_pitch_mm = pitch_mm, array.gap_mm = gap_mm, array.offset_mm = offset_mm;
  array.viewing_distance_mm = kInfinity;
}

namespace {

PanelSize microlens_size(const OpticsParams& params, Vec2i) {
  constexpr float kHexagonalRow = 0.8660254f;  // row pitch divided by lens pitch, sqrt(3)/2
  const float pixels = lens_pixels_across(params);
  if (params.lens_pixels.y > 0.0f && params.lens_pixels.y != pixels)
    throw usage_error("lens-pixels", fmt::format("is {} pixels across but {} down", pixels, params.lens_pixels.y),
                      "the same number across and down");
  const float row_pixels = params.packing == LensPacking::kHexagonal ? pixels * kHexagonalRow : pixels;
  if (params.size.x > 0) {
    if (params.lenses.y > 0) require_agreement(params.size.y, params.lenses.y, row_pixels, "down");
    return {params.size.x, params.size.y, pixels};
  }
  const int lenses = params.lenses.x > 0 ? params.lenses.x : kDefaultLenses;
  return {covered_pixels(lenses, pixels), covered_pixels(params.lenses.y > 0 ? params.lenses.y : lenses, row_pixels), pixels};
}

OpticsModel array_of_params(const ModelSetup& setup) {
  const Panel& panel = setup.panel;
  MicrolensArray array;
  array.packing = setup.params.packing;
  const float cell = setup.size.lens_pixels * panel.pixel_pitch_mm;
  const float row = array.packing == LensPacking::kHexagonal ? cell * std::sqrt(0.75f) : cell;
  const LensGeometry lens = lens_geometry(cell, setup.params, setup.viewing_distance_mm);
  const Vec2f extent = Vec2f(panel.width, panel.height) * panel.pixel_pitch_mm;
  array.lens_pitch_mm = lens.pitch_mm;
  array.gap_mm = lens.gap_mm;
  array.offset_mm =
      Vec2f(cell_center_nearest_middle(extent.x, cell), cell_center_nearest_middle(extent.y, row)) * lens.pitch_per_cell;
  array.viewing_distance_mm = setup.viewing_distance_mm;
  return array;
}

}  // namespace

constinit const OpticsKindInfo microlens_kind{.name = kind_of(MicrolensArray{}),
                                              .takes = {"lenses", "lens-pixels", "packing"},
                                              .panel_size = microlens_size,
                                              .make_model = array_of_params};

const OpticsKindInfo& kind_info(const MicrolensArray&) { return microlens_kind; }

}  // namespace lippmann

#include "lippmann/display/display.hpp"

#include <cmath>
#include <numbers>

namespace lippmann {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

int cell_at(const Calibration& calibration, int column, int row) {
  const bool by_columns = calibration.patterns == Calibration::Patterns::kColumns;
  int cell = 0;
  switch (calibration.cell_pattern) {
    case 1:
      cell = (column + row) % 2;
      break;
    case 2:
      cell = by_columns ? column % 2 : row % 4;
      break;
    case 3:
      cell = (row + 2 * (column % 2)) % 4;
      break;
    case 4:
      cell = by_columns ? row % 2 : column % 2;
      break;
    default:
      break;
  }
  return cell % static_cast<int>(calibration.cells.size());
}

/// Returns whether flip_image_x negates the step s from a sub-pixel to the next (see Calibration).
bool flips_step(const Calibration& calibration) {
  return calibration.flip_image_x && calibration.flip != Calibration::Flip::kSlope;
}

SubPixelOffsets offsets_of(const Calibration& calibration) {
  if (calibration.cells.empty()) return striped_sub_pixels(flips_step(calibration) != calibration.flip_sub_pixels);
  SubPixelOffsets offsets;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 2; ++column) {
      SubPixelCell cell = calibration.cells[static_cast<std::size_t>(cell_at(calibration, column, row))];
      if (calibration.flip_sub_pixels) std::swap(cell[0], cell[2]);
      offsets[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = cell;
    }
  return offsets;
}

struct Lenses {
  double pitch_mm, gap_mm;
};

Lenses lenses_of(const Display& display, double distance_mm) {
  // A cell is the area of the panel below one lens. It is p (1 + g/V) wide, with the gap g, the lens pitch p and the viewing
  // distance V. Solving 2 atan(cell / 2g) = cone for g gives g = p / (2 tan(cone/2) - p/V).
  const double p = display.lenses.pitch_mm, spread = 2.0 * std::tan(0.5 * display.view_cone_deg * kDegree);
  return {p, p / (spread - p / distance_mm)};
}

/// Returns the position of the panel's centre across the lenses, x cos(slant) - y sin(slant), in pixels.
double centre_of_strips(const Display& display, const LensStrips& strips) {
  return 0.5 * (display.pixels.x * strips.cosine - display.pixels.y * strips.sine);
}

/// Returns the distance in mm, across the lenses, from the panel's centre to the centre of a lens, between 0.5 and 1.5 pitches.
float sheet_offset_mm(const Display& display) {
  const LensStrips strips = lens_strips(display);
  const double edge = (strips.start_px - centre_of_strips(display, strips)) / strips.cell_px;
  return static_cast<float>((edge - std::floor(edge) + 0.5) * display.lenses.pitch_mm);
}

}  // namespace

double viewing_distance_mm(const Display& display) {
  return display.viewing_distance_mm.value_or(0.5 * display.size_mm().y / std::tan(7.0 * kDegree));
}

double periods_of(const Display& display) {
  const Calibration& c = display.calibration;
  return c.pitch * display.pixels.x / display.dpi * std::cos(std::atan(1.0 / c.slope));
}

double tilt_of(const Display& display) {
  const Calibration& c = display.calibration;
  const double tilt = display.pixels.y / (display.pixels.x * c.slope);
  return c.flip_image_x ? -tilt : tilt;
}

SlantedPanel slanted_panel(const Display& display, double distance_mm) {
  const Calibration& c = display.calibration;
  SlantedPanel panel;
  panel.periods = periods_of(display), panel.tilt = tilt_of(display);
  // For a pixel centred at x, panel.sub_pixels places the sub-pixel of colour c = 0, 1, 2 at x + (c - 1) s. The formula of
  // Calibration places it at x + c s. panel.center makes up for this difference of s.
  const double step = c.cells.empty() ? (flips_step(c) ? -1.0 : 1.0) / (3.0 * display.pixels.x) : 0.0;
  const bool flips_center = c.flip_image_x && c.flip == Calibration::Flip::kSlopeStepAndCenter;
  panel.center = c.center + (flips_center ? 0.5 : 0.0) - panel.periods * step;
  panel.inverted = c.inversion == Calibration::Inversion::kAlways || c.invert;
  panel.view_cone = static_cast<float>(display.view_cone_deg * kDegree);
  panel.distance_mm = static_cast<float>(distance_mm);
  panel.sub_pixels = offsets_of(c);
  return panel;
}

Optics native_optics(const Display& display) {
  const double distance = viewing_distance_mm(display);
  Optics optics;
  optics.panel = {display.pixels.x, display.pixels.y, static_cast<float>(display.pixel_mm())};
  if (display.kind == DisplayKind::kSlantedPanel) {
    optics.model = slanted_panel(display, distance);
    return optics;
  }
  const Lenses lenses = lenses_of(display, distance);
  const auto pitch = static_cast<float>(lenses.pitch_mm), gap = static_cast<float>(lenses.gap_mm);
  if (display.kind == DisplayKind::kLenticularSheet) {
    LenticularSheet sheet;
    sheet.lens_pitch_mm = pitch, sheet.gap_mm = gap;
    sheet.offset_mm = display.lenses.phase_px ? sheet_offset_mm(display) : 0.5f * pitch;
    sheet.slant = static_cast<float>(display.lenses.slant_deg * kDegree);
    sheet.viewing_distance_mm = static_cast<float>(distance);
    optics.model = sheet;
  } else {
    MicrolensArray array;
    array.packing = display.lenses.packing;
    array.lens_pitch_mm = pitch, array.gap_mm = gap, array.offset_mm = Vec2f(0.5f * pitch);
    array.viewing_distance_mm = static_cast<float>(distance);
    optics.model = array;
  }
  return optics;
}

std::optional<Optics> quilt_optics(const Display& display) {
  if (!display.quilt) return std::nullopt;
  const DisplayQuilt& quilt = *display.quilt;
  const Vec2d size = display.size_mm();
  const double pixel_width = size.x / (quilt.width / quilt.columns), pixel_height = size.y / (quilt.height / quilt.rows);
  MultiView views{quilt.columns, quilt.rows};
  views.view_cone = static_cast<float>(display.view_cone_deg * kDegree);
  views.distance_mm = static_cast<float>(viewing_distance_mm(display));
  views.pixel_height = static_cast<float>(pixel_height / pixel_width);
  return Optics{.panel = {quilt.width, quilt.height, static_cast<float>(pixel_width)}, .model = views};
}

LensStrips lens_strips(const Display& display) {
  const double distance = viewing_distance_mm(display), slant = display.lenses.slant_deg * kDegree;
  const Lenses lenses = lenses_of(display, distance);
  LensStrips strips;
  strips.cosine = std::cos(slant), strips.sine = std::sin(slant);
  strips.cell_px = lenses.pitch_mm * (1.0 + lenses.gap_mm / distance) / display.pixel_mm();
  const std::optional<double> phase = display.lenses.phase_px;
  const double edge = phase ? *phase * strips.cosine - 0.5 * strips.sine : centre_of_strips(display, strips);
  strips.start_px = edge - strips.cell_px * std::ceil(edge / strips.cell_px);
  return strips;
}

double pixels_below_lens(const Display& display) {
  if (display.kind == DisplayKind::kSlantedPanel) return display.pixels.x / periods_of(display);
  return display.lenses.pitch_mm / display.pixel_mm();
}

std::optional<double> crosstalk_of_picture(const Display& display, const Optics& optics) {
  const std::optional<ViewTiles> views = view_tiles(optics);
  if (!display.crosstalk_px || !views) return display.crosstalk_px;
  return *display.crosstalk_px * views->columns * views->rows / pixels_below_lens(display);
}

int views_of(const Display& display) {
  if (display.quilt) return display.quilt->columns * display.quilt->rows;
  if (display.kind == DisplayKind::kSlantedPanel) return static_cast<int>(3.0 * pixels_below_lens(display));
  if (display.kind == DisplayKind::kLenticularSheet) return static_cast<int>(lens_strips(display).cell_px + 1e-6);
  const int across = static_cast<int>(pixels_below_lens(display) + 1e-6);
  return across * across;
}

const char* to_string(DisplayKind kind) {
  switch (kind) {
    case DisplayKind::kLenticularSheet:
      return "lenticular-sheet";
    case DisplayKind::kMicrolensArray:
      return "microlens-array";
    case DisplayKind::kSlantedPanel:
      break;
  }
  return "slanted-panel";
}

}  // namespace lippmann

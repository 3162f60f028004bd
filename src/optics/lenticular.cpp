#include "optics/lenticular.hpp"

namespace lippmann {

LenticularConstants<double> make_lenticular(const Panel& panel, const LenticularSheet& sheet, double z_front_mm) {
  const double m = panel.pixel_pitch_mm, gap = sheet.gap_mm, distance = sheet.viewing_distance_mm, slant = sheet.slant;
  LenticularConstants<double> c{};
  c.half_width_px = 0.5 * panel.width, c.half_height_px = 0.5 * panel.height;
  c.pixel_pitch_mm = m, c.gap_mm = gap;
  c.cosine = std::cos(slant), c.sine = std::sin(slant), c.inverse_cosine = 1.0 / c.cosine;
  c.eye_y_mm = sheet.eye_height_mm;
  c.row_vergence = 1.0 / (distance + gap);
  c.z_front_mm = z_front_mm;
  // y + (z_front + g) dy/dz, arranged so that all rows meet exactly at the eye's height where z_front = V.
  c.row_scale = std::isinf(distance) ? 1.0 : (distance - z_front_mm) * c.row_vergence;
  c.row_shift_mm = c.eye_y_mm * (z_front_mm + gap) * c.row_vergence;
  c.axis = make_lens_axis({.pitch_mm = sheet.lens_pitch_mm,
                           .offset_mm = sheet.offset_mm,
                           .gap_mm = gap,
                           .viewing_distance_mm = distance,
                           .eye_mm = c.eye_y_mm * c.sine,
                           .pixel_pitch_mm = m,
                           .size_px = slant == 0.0 ? panel.width : 0});
  return c;
}

LIPPMANN_MULTIVERSION
void write_rays(const LenticularRays& constants, const RayFrame& frame, const float* px, const float* py, int count,
                const RayArrays& rays) {
  const LenticularRays c = constants;
  const RayFrame f = frame;
  const RayArrays r = rays;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) write_ray(f, crossing(c, px[i], py[i]), r, i);
}

namespace {

/// The panel's extent in xi, pixels from its centre.
double half_extent_px(const LenticularConstants<double>& c) {
  return c.half_width_px * c.cosine + c.half_height_px * std::abs(c.sine);
}

/// All pixel centres of one panel row that lie below the lens that covers xi_mm.
void append_row_of_cell(const LenticularConstants<double>& c, double xi_mm, double py, std::vector<Vec2f>& pixels) {
  const double row = std::floor(py) + 0.5, w = c.half_height_px - row;
  const int lens = lens_at(c.axis, xi_mm), width = static_cast<int>(2 * c.half_width_px);
  const double cell_start = c.axis.start_px + lens * c.axis.cell_px;
  const double first = (cell_start - w * c.sine) * c.inverse_cosine + c.half_width_px;
  const double last = (cell_start + c.axis.cell_px - w * c.sine) * c.inverse_cosine + c.half_width_px;
  const int begin = static_cast<int>(std::clamp(std::floor(first), 0.0, 1.0 * width));
  const int end = static_cast<int>(std::clamp(std::ceil(last), 0.0, 1.0 * width));
  for (int i = begin; i < end; ++i) {
    const double xi = (i + 0.5 - c.half_width_px) * c.cosine + w * c.sine;
    if (cell_of(c.axis, xi) == lens) pixels.emplace_back(i + 0.5, row);
  }
}

}  // namespace

void pixels_seeing(const Panel& panel, const LenticularSheet& sheet, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const LenticularConstants<double> c = make_lenticular(panel, sheet, 0.0);
  const double x = point_mm.x, y = point_mm.y, z = point_mm.z, xi = x * c.cosine + y * c.sine;
  // The row: y_panel + (z + g) (y_e - y_panel) / (V + g) = y.
  const double toward_eye = (z + c.gap_mm) * c.row_vergence;
  const double py = c.half_height_px - (y - c.eye_y_mm * toward_eye) / (1.0 - toward_eye) / c.pixel_pitch_mm;
  if (!(py >= 0.0 && py < panel.height)) return;
  if (in_lens_plane(c.axis, z)) return append_row_of_cell(c, xi, py, pixels);

  const double w = c.half_height_px - py, extent = half_extent_px(c), half_cell = 0.5 * c.axis.cell_px;
  const LensRange range = lenses_near(c.axis, xi, z, half_cell, -extent, extent);
  for (int k = range.first; k <= range.last; ++k) {
    const double offset = image_offset_px(c.axis, c.axis.lens0_mm + k * c.axis.pitch_mm, xi, z);
    if (!(offset >= -half_cell && offset < half_cell)) continue;
    const double s = c.axis.start_px + (k + 0.5) * c.axis.cell_px + offset;
    const double px = (s - w * c.sine) * c.inverse_cosine + c.half_width_px;
    if (px >= 0.0 && px < panel.width) pixels.emplace_back(px, py);
  }
}

}  // namespace lippmann

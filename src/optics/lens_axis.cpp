#include "optics/lens_axis.hpp"

#include <algorithm>

namespace lippmann {
namespace {

constexpr double kAlignmentTolerancePx = 0.01;

/// Rounds the width and the edges of cells to whole pixels if they differ only by rounding errors. Cell 0 then begins at pixel
/// 0.
void snap_to_pixels(LensAxis<double>& axis, int size_px) {
  const double whole = std::round(axis.cell_px);
  if (size_px <= 0 || whole < 1.0) return;
  const double cells_before = std::round(axis.start_px / whole);  // number of cells between pixel 0 and cell 0
  const double farthest_cell = 0.5 * size_px / whole + 1.0;
  const double misalignment = std::abs(axis.start_px - whole * cells_before) + farthest_cell * std::abs(axis.cell_px - whole);
  if (!(misalignment < kAlignmentTolerancePx)) return;
  axis.cell_px = whole, axis.start_px = 0.0;
  axis.lens0_mm -= cells_before * axis.pitch_mm;
  axis.whole_pixels = static_cast<int>(whole);
}

}  // namespace

LensAxis<double> make_lens_axis(const LensAxisSpec& spec) {
  const double vergence = 1.0 / spec.viewing_distance_mm, spread = spec.gap_mm * vergence;
  LensAxis<double> axis{};
  axis.lens0_mm = spec.offset_mm - spec.pitch_mm * std::round(spec.offset_mm / spec.pitch_mm);
  axis.pitch_mm = spec.pitch_mm;
  axis.slope_per_px = spec.parallax * spec.pixel_pitch_mm / spec.gap_mm;
  axis.vergence = vergence;
  axis.eye_mm = spec.eye_mm;
  axis.cell_px = spec.pitch_mm * (1.0 + spread) / spec.pixel_pitch_mm;
  axis.start_px =
      spec.centre_px + (axis.lens0_mm * (1.0 + spread) - spec.eye_mm * spread) / spec.pixel_pitch_mm - 0.5 * axis.cell_px;
  snap_to_pixels(axis, spec.size_px);
  axis.cells_per_px = 1.0 / axis.cell_px;
  return axis;
}

LensRange lenses_near(const LensAxis<double>& axis, double x_mm, double z_mm, double reach_px, double s_low, double s_high) {
  LensRange range{cell_of(axis, s_low), cell_of(axis, s_high)};
  // The image offset in pixels is a linear function of the lens position l: per_lens * l + at_zero.
  const double at_zero = image_offset_px(axis, 0.0, x_mm, z_mm);
  const double per_lens = (1.0 / z_mm - axis.vergence) / axis.slope_per_px;
  const double a = (-reach_px - at_zero) / per_lens, b = (reach_px - at_zero) / per_lens;
  if (!std::isfinite(a) || !std::isfinite(b)) return range;
  const double first = (std::min(a, b) - axis.lens0_mm) / axis.pitch_mm - 1.0;
  const double last = (std::max(a, b) - axis.lens0_mm) / axis.pitch_mm + 1.0;
  const double low = range.first, high = range.last;
  return {static_cast<int>(std::clamp(std::ceil(first), low, high + 1.0)),
          static_cast<int>(std::clamp(std::floor(last), low - 1.0, high))};
}

}  // namespace lippmann

#include "lippmann/optics/view_lens.hpp"

namespace lippmann {

bool can_have_view_lens(const Optics& optics) { return is_single_view(optics) || view_tiles(optics).has_value(); }

ViewLens lens_by_aperture(const ViewLens& lens, const Optics& optics, float units_per_mm) {
  if (!(lens.f_number > 0.0f)) return lens;
  const float focal_length_mm = kSensorWidthMm * viewing_distance_mm(optics) / window_size_mm(optics).x;
  constexpr float kUnitsPerRealMm = 1e-3f;
  return {focal_length_mm / lens.f_number * kUnitsPerRealMm / units_per_mm, 0.0f, lens.focal_plane_mm};
}

}  // namespace lippmann

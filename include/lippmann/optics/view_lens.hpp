// The lens in place of each view's pinhole, for depth of field: things away from the focal plane blur as in a photograph.
//
// The lens is a thin one, a disc in the plane of the eyes, parallel to the display. All rays of a pixel cross where the ray of
// its pinhole crosses the focal plane. A point at depth z becomes a disc of the diameter A |z - f| / (D - z) in the focal plane
// z = f, and of that times D / (D - f) on the display's plane z = 0: A is the aperture, D the distance of the eyes.
//
// Only views have such eyes: single views, quilts, camera grids and pairs. Pixels below lenses have directions of their own,
// and blur with depth as their lenses do.
#pragma once

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Closed by default: a pinhole. At most one of aperture_mm and f_number is not 0.
struct ViewLens {
  float aperture_mm = 0.0f;     ///< diameter, in the display's millimetres; 0: see f_number
  float f_number = 0.0f;        ///< that of a camera with kSensorWidthMm, in scenes whose unit is the metre; 0: a pinhole
  float focal_plane_mm = 0.0f;  ///< z of what is sharp: 0 the display's plane, above 0 in front of it

  bool is_open() const { return aperture_mm > 0.0f || f_number > 0.0f; }
};

/// Width of the sensor that f-numbers are for, as Blender's cameras have by default: the focal length follows from the view's
/// width.
inline constexpr float kSensorWidthMm = 36.0f;

/// The same lens by its aperture alone. units_per_mm: metres of the scene for each millimetre of the display, as
/// PlacedOptics::units_per_mm. An f-number N is the aperture F / N, F = kSensorWidthMm D / window width.
ViewLens lens_by_aperture(const ViewLens& lens, const Optics& optics, float units_per_mm);

/// Whether the optics are views, whose eyes may have lenses.
bool can_have_view_lens(const Optics& optics);

}  // namespace lippmann

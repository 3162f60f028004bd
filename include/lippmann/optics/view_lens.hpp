// A thin lens in place of each view's pinhole, for depth of field.
//
// The lens is a disc in the plane of the eyes, parallel to the display. All rays of a pixel meet where the pinhole ray crosses
// the focal plane z = f. With aperture A and eye distance D, a point at depth z becomes a disc of diameter A |z - f| / (D - z)
// in the focal plane. On the display plane z = 0, the disc is D / (D - f) times as large.
//
// Only views can have such lenses: single views, quilts, camera grids and stereo pairs. Pixels below lens arrays have their own
// directions and blur with depth by the optics of the array.
#pragma once

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// The opening of the lens, by default a pinhole. At most one of aperture_mm and f_number may be non-zero.
struct ViewLens {
  float aperture_mm = 0.0f;  ///< diameter in mm of the display frame; 0: defined by f_number
  /// F-number on a sensor of kSensorWidthMm, for scenes in metres; 0: a pinhole, unless aperture_mm is set.
  float f_number = 0.0f;
  float focal_plane_mm = 0.0f;  ///< z of the plane in focus: 0 is the display plane, above 0 in front of it

  bool is_open() const { return aperture_mm > 0.0f || f_number > 0.0f; }
};

/// Sensor width that f-numbers refer to (Blender's default). The focal length follows from the view's width.
inline constexpr float kSensorWidthMm = 36.0f;

/// Returns the lens with its f-number converted to an aperture: F / N with F = kSensorWidthMm D / window width. units_per_mm:
/// metres of the scene per millimetre of the display, as in PlacedOptics::units_per_mm.
ViewLens lens_by_aperture(const ViewLens& lens, const Optics& optics, float units_per_mm);

/// Returns whether the optics consist of views, which can have lenses.
bool can_have_view_lens(const Optics& optics);

}  // namespace lippmann

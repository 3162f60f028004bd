// A thin lens in place of each view's pinhole, for depth of field.
//
// The lens is a disc in the plane of the eyes, parallel to the display. All rays of a pixel meet where the pinhole ray crosses
// the focal plane z = f. With aperture A and eye distance D, a point at depth z blurs to a disc of diameter A |z - f| / (D - z)
// in the focal plane. In the display plane z = 0, the disc is D / (D - f) times as large.
//
// Only views can have such lenses: single views, quilts, camera grids and stereo pairs.
#pragma once

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// The opening of the lens, by default a pinhole. At most one of aperture_mm and f_number may be non-zero.
struct ViewLens {
  float aperture_mm = 0.0f;  ///< diameter of the lens in mm of the display frame; 0: f_number determines it
  /// F-number of a camera with a sensor of width kSensorWidthMm, for a scene in metres. 0: aperture_mm determines the aperture.
  float f_number = 0.0f;
  float focal_plane_mm = 0.0f;  ///< z of the plane in focus; the display plane is z = 0

  bool is_open() const { return aperture_mm > 0.0f || f_number > 0.0f; }
};

/// Sensor width that f-numbers refer to (Blender's default).
inline constexpr float kSensorWidthMm = 36.0f;

/// Returns the lens with its f-number N converted to the aperture F / N. The focal length is F = kSensorWidthMm D / (width of
/// the window) with the eye distance D. `units_per_mm` is the number of metres in the scene per millimetre of the display, as
/// in PlacedOptics::units_per_mm.
ViewLens lens_by_aperture(const ViewLens& lens, const Optics& optics, float units_per_mm);

/// Returns whether the optics consist of views, which can have lenses.
bool can_have_view_lens(const Optics& optics);

}  // namespace lippmann

// The pinhole cameras of the views of a picture: the positions of their eyes, and the pixel grid in the plane z = 0, which all
// of them share.
//
// Views of a quilt are off-axis pinholes by construction (optics/multi_view.hpp). So are the views of a lens array with a
// finite viewing distance V. Pixels at offset o from the centres of their cells have rays of slope -l/V - o/g through lens l,
// which all meet at x = -o V/g, z = V. Neighbouring eyes are m V/g apart, where m is the pixel pitch, and samples are one lens
// pitch p apart. Along the lenses of a lenticular sheet, which have no power, samples are m V/(V + g) apart. A parallax below 1
// (with_parallax) moves these eyes closer together.
#pragma once

#include <optional>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

/// Parallel cameras that look along -z, each off-axis through the same rectangle in the plane z = 0. Computer vision data sets
/// use the same model. Lengths in mm of the display frame (optics/optics.hpp).
struct ViewCameras {
  double distance_mm = 0.0;         ///< distance from every eye to the plane z = 0, where the views coincide
  Vec2d pixel_mm{0.0};              ///< size of a view's pixel in the plane z = 0
  Vec2d centre_px{0.0};             ///< position of x = y = 0 in every view, from its top left corner
  std::vector<Vec2d> eyes_mm = {};  ///< position of each view's eye, x right and y up
};

/// Returns the cameras of the views, if every view consists of whole pixels. Returns none for other optics, and if the views
/// are parallel projections (lenses viewed from infinity).
std::optional<ViewCameras> view_cameras(const Optics& optics);

}  // namespace lippmann

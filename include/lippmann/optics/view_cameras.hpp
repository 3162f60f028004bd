// The pinhole cameras of the views of a picture: the positions of the eyes, and the pixel grid in the plane z = 0 that all
// views share.
//
// Views of a quilt are off-axis pinholes by construction (optics/multi_view.hpp). So are the views of a lens array with a
// finite viewing distance V. With the gap g and the pixel pitch m:
// 1. A pixel at offset o from the centre of its cell has a ray of slope -l/V - o/g through its lens at l. The rays of all
//    pixels with the same offset meet at x = -o V/g, z = V, which is the eye of their view.
// 2. Neighbouring eyes are m V/g apart. A parallax below 1 (with_parallax()) moves the eyes closer together.
// 3. Samples are one lens pitch apart. Along the lenses of a lenticular sheet, which have no power, samples are m V/(V + g)
//    apart.
#pragma once

#include <optional>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

/// Parallel cameras that look along -z, off-axis through the same rectangle in the plane z = 0. Lengths are in mm of the
/// display frame (optics/optics.hpp).
struct ViewCameras {
  double distance_mm = 0.0;         ///< distance from every eye to the plane z = 0, where the views coincide
  Vec2d pixel_mm{0.0};              ///< size of a view's pixel in the plane z = 0
  Vec2d centre_px{0.0};             ///< position of x = y = 0 in every view, from its top left corner
  std::vector<Vec2d> eyes_mm = {};  ///< position of each view's eye, x right and y up
};

/// Returns the cameras of the views if every view consists of whole pixels. Returns nothing for other optics, and for lenses
/// viewed from infinity, whose views are parallel projections.
std::optional<ViewCameras> view_cameras(const Optics& optics);

}  // namespace lippmann

// The cameras that the views of a picture are: where their eyes stand and how their pixels lie in the plane z = 0.
//
// Views of a quilt are off-axis pinholes by construction (optics/multi_view.hpp). So are the views of a lens array that is seen
// from a distance V: the pixels at offset o from the centres of their cells have rays of slope -l/V - o/g through lens l, which
// all pass through x = -o V/g at z = V, and one sample per lens, a lens pitch p apart. Their eyes stand m V/g apart, m the
// pixel pitch, and the distance between samples is p; down a lenticular sheet, where lenses have no power, it is m V/(V + g).
// A parallax (with_parallax) draws all of these eyes nearer together.
#pragma once

#include <optional>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

/// Parallel cameras that look along -z through one plane z = 0, each off its axis: the model of render's views and of the data
/// sets of vision research. Lengths in mm of the display frame (optics/optics.hpp).
struct ViewCameras {
  double distance_mm = 0.0;         ///< from every eye to the plane z = 0, where views coincide
  Vec2d pixel_mm{0.0};              ///< width and height that a view's pixel covers in that plane
  Vec2d centre_px{0.0};             ///< where the middle of the plane, x = y = 0, lies in every view, from its top left corner
  std::vector<Vec2d> eyes_mm = {};  ///< x to the right and y up, by view
};

/// The cameras of views of whole pixels. None where there are no such views, or where they are parallel projections: of lenses
/// that are seen from infinity.
std::optional<ViewCameras> view_cameras(const Optics& optics);

}  // namespace lippmann

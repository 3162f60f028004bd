// Converts between depth and disparity, the shift of a point in pixels from one view to the next.
//
// Let parallel cameras with baseline b be at distance D from the plane z = 0, and let their pixels be p wide in that plane. A
// point at depth z then moves by
//   d = b z / ((D - z) p)
// pixels. Points in front of the plane move to the left as the eye moves right.
#pragma once

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the depth in mm of points with this disparity. The baseline is the mean distance between neighbouring eyes. Throws a
/// usage Error naming `parameter` if the optics have fewer than two views or views without cameras, or if no point has this
/// disparity.
double depth_of_disparity_px(const Optics& optics, double disparity_px, const char* parameter);

}  // namespace lippmann

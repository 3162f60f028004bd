// Depths as disparities: by how many pixels a point moves from one view to the next.
//
// Parallel cameras a baseline b apart, at the distance D from the plane z = 0, in which a pixel of theirs is p wide. A point at
// depth z moves by
//   d = b z / ((D - z) p)
// pixels, to the left as the eye moves right where it is in front of the plane. That is the disparity of
// layout/hci_parameters.hpp, and the shift of shift-and-sum refocusing. It does not depend on what is assumed of the cameras.
#pragma once

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// The depth z in mm, by the mean distance between neighbouring eyes. Throws a usage Error naming `parameter` for optics whose
/// views are no cameras a distance apart, and for disparities that no point has: -b / p, of points at infinity, or less.
double depth_of_disparity_px(const Optics& optics, double disparity_px, const char* parameter);

}  // namespace lippmann

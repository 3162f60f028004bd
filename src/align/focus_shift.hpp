// Finds the horizontal shifts of aligned images that keep one scene point still, so that it is shown in the plane of the
// display.
//
// The point is tracked from the middle image outwards. Shared points near it give an approximate position. The correlation of a
// patch with the patch of the middle image then gives the exact position.
#pragma once

#include <cstddef>
#include <vector>

#include "align/register_pictures.hpp"

namespace lippmann {

struct FocusShifts {
  /// Shift of each image in pixels, to be added to the x of its similarity; 0 for the middle image.
  std::vector<double> shifts;
  std::size_t unseen = 0;  ///< number of images without a matching patch, whose shifts follow from shared points only
};

/// Returns the shifts of all images. focus: position in pixels of the middle image.
FocusShifts focus_shifts(const RegisteredPictures& registered, Vec2d focus);

}  // namespace lippmann

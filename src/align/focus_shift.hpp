// Finds the horizontal shifts of aligned images that keep one scene point still, which then lies on the display.
//
// The point is tracked from the middle image outwards. Shared points near it give an approximate position, and the correlation
// of a patch with the middle image gives the exact one.
#pragma once

#include <cstddef>
#include <vector>

#include "align/register_pictures.hpp"

namespace lippmann {

struct FocusShifts {
  std::vector<double> shifts;  ///< of each image, pixels, to add to its similarity's x; 0 for the middle image
  std::size_t unseen = 0;      ///< number of images without a matching patch, which use shared points only
};

/// Returns the shifts. focus: pixels of the middle image.
FocusShifts focus_shifts(const RegisteredPictures& registered, Vec2d focus);

}  // namespace lippmann

// Finds the horizontal shifts of aligned images that keep one scene point still, so that it is shown in the plane of the
// display.
//
// The point is tracked from the middle image outwards. Shared points near it give an approximate position. Correlation with a
// patch of the middle image gives the exact position.
#pragma once

#include <cstddef>
#include <vector>

#include "align/register_pictures.hpp"

namespace lippmann {

struct FocusShifts {
  std::vector<double> shifts;
  std::size_t unseen = 0;
};

FocusShifts focus_shifts(const RegisteredPictures& registered, Vec2d focus);

}  // namespace lippmann

// Finds the horizontal shifts of aligned pictures that make one place of the scene stand still: it then lies on the display.
//
// Followed from picture to picture, from the middle one outwards: places that neighbours share near it say about where it is,
// the likeness of a patch around it to that of the middle picture says exactly where.
#pragma once

#include <cstddef>
#include <vector>

#include "align/register_pictures.hpp"

namespace lippmann {

struct FocusShifts {
  std::vector<double> shifts;  ///< of each picture, to add to its similarity's x, pixels; 0 of the middle one
  std::size_t unseen = 0;      ///< how many pictures show no patch like it: shared places alone say where it is
};

/// `focus`: pixels of the middle picture.
FocusShifts focus_shifts(const RegisteredPictures& registered, Vec2d focus);

}  // namespace lippmann

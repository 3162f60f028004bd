// How far places of a stereo pair move from the left picture to the right one: dense disparity.
//
// The pair must be aligned (align/align_pictures.hpp): places lie in the same row of both pictures.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// x in the left picture less x in the right one, in pixels of the pictures: above 0 in front of the display. Of 1 channel
/// each, of at most 1600 pixels a side. Places that only one picture shows have the disparity of what lies behind.
struct StereoDisparity {
  Image of_left, of_right;
  double least = 0.0, most = 0.0;  ///< the range that was searched
};

/// Pictures of one size; `name` is what errors and warnings name. Warns if rows do not agree. Throws Error if the pictures
/// share too few places.
StereoDisparity disparity_of_pair(const Picture& left, const Picture& right, const std::string& name, const Context& context);

}  // namespace lippmann

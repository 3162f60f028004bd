#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// The disparity of a point is its x in the left image minus its x in the right image, in pixels of the input images. It is
/// positive in front of the display. Both images have one channel and at most 1600 pixels a side. Points that only one image
/// shows have the disparity of the surface behind them.
struct StereoDisparity {
  Image of_left, of_right;
  double least = 0.0, most = 0.0;
};

/// Computes the disparities of two images of one size. name: name of the pair in errors and warnings. Warns if the rows do not
/// match. Throws Error if the images share too few points.
StereoDisparity disparity_of_pair(const Picture& left, const Picture& right, const std::string& name, const Context& context);

}  // namespace lippmann

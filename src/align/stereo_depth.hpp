#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// Disparities: x in the left image minus x in the right one, in pixels of the input images; positive in front of the display.
/// 1 channel each, at most 1600 pixels a side. Points that only one image shows have the disparity of the surface behind them.
struct StereoDisparity {
  Image of_left, of_right;
  double least = 0.0, most = 0.0;
};

/// Computes the disparities of two images of one size. name: name of the pair in errors and warnings. Warns if the rows do not
/// match. Throws Error if the images share too few points.
StereoDisparity disparity_of_pair(const Picture& left, const Picture& right, const std::string& name, const Context& context);

}  // namespace lippmann

// Converts a stereo pair to two images with depth, from which other views are made (replay/depth_views.hpp).
//
// The baseline of a pair in millimetres is unknown. The views therefore span the pair: the first view is the left image and the
// last one the right image, whatever the angle between them.
#pragma once

#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the left and the right image with depth, with their eyes at those of the leftmost and the rightmost view of
/// `optics`. pair: two views with cameras of one distance and pixel size, the left one first. name: the name in errors. Throws
/// Error if the images have too few points in common, or if no two views of the optics lie side by side.
std::vector<LightField> pictures_with_depth(const LightField& pair, const Optics& optics, const std::string& name,
                                            const Context& context);

}  // namespace lippmann

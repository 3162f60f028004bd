// A stereo pair as two pictures with depth, from which other views are made (replay/depth_views.hpp).
//
// A pair does not say how far apart its cameras stood in millimetres. The views span the pair: the first one is the left
// picture, the last one the right one, whatever the angle between them.
#pragma once

#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// `pair`: two views with cameras of one distance and pixel size, the left one first. `optics`: those of the views. The left
/// and the right picture, each with its depth and its eye at that of the leftmost and the rightmost view. `name` is what errors
/// name. Throws Error if the pictures share too few places, or if the views have no two eyes side by side.
std::vector<LightField> pictures_with_depth(const LightField& pair, const Optics& optics, const std::string& name,
                                            const Context& context);

}  // namespace lippmann

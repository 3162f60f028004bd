// Converts a stereo pair to two images with depth, from which views for other eyes can be made (replay/depth_views.hpp). The
// baseline of a pair is unknown. Its images are therefore taken as the two outermost views.
#pragma once

#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the left and the right image with depth. Their eyes are the outermost eyes of the views of `optics`. `pair` holds
/// the left view and then the right view. `name` names the pair in errors. Throws Error if the images have too few points in
/// common, or if no two views of the optics lie side by side.
std::vector<LightField> pictures_with_depth(const LightField& pair, const Optics& optics, const std::string& name,
                                            const Context& context);

}  // namespace lippmann

// How photometric webs shine, as coarsely as the choice of lights asks for it: an axis, a cone that holds all light, and the
// mean by the angle to the axis.
#pragma once

#include <span>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "shading/light_tree.hpp"

namespace lippmann {

struct WebBeam {
  Vec3f axis{0.0f, 0.0f, -1.0f};  ///< unit, in the light's space: the mean direction of its light
  float half_angle = kPi;         ///< no light goes farther from the axis
  LightProfile profile;           ///< around the axis
};

/// By web.
std::vector<WebBeam> beams_of(std::span<const PhotometricWeb> webs);

}  // namespace lippmann

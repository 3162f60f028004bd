// Coarse description of photometric webs for the choice of lights: an axis, a cone that contains all light, and the mean
// emission by the angle to the axis.
#pragma once

#include <span>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "shading/light_tree.hpp"

namespace lippmann {

struct WebBeam {
  Vec3f axis{0.0f, 0.0f, -1.0f};  ///< unit, in the light's space: the mean direction of its light
  float half_angle = kPi;         ///< no light at larger angles to the axis
  LightProfile profile;           ///< around the axis
};

/// Returns the beams of the webs, in their order.
std::vector<WebBeam> beams_of(std::span<const PhotometricWeb> webs);

}  // namespace lippmann

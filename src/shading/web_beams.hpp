// Coarse descriptions of photometric webs, by which lights are chosen: an axis, a cone that contains all light, and the mean
// emission as a function of the angle to the axis.
#pragma once

#include <span>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "shading/light_tree.hpp"

namespace lippmann {

struct WebBeam {
  Vec3f axis{0.0f, 0.0f, -1.0f};  ///< mean direction of the emission in the light's space, unit length
  float half_angle = kPi;         ///< the web does not emit at larger angles to the axis
  LightProfile profile;           ///< emission as a function of the angle to `axis`
};

std::vector<WebBeam> beams_of(std::span<const PhotometricWeb> webs);

}  // namespace lippmann

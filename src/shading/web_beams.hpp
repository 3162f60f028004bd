// Coarse descriptions of photometric webs, by which lights are chosen: an axis, a cone that contains all light, and the mean
// emission as a function of the angle to the axis.
#pragma once

#include <span>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "shading/light_tree.hpp"

namespace lippmann {

struct WebBeam {
  Vec3f axis{0.0f, 0.0f, -1.0f};
  float half_angle = kPi;
  LightProfile profile;
};

std::vector<WebBeam> beams_of(std::span<const PhotometricWeb> webs);

}  // namespace lippmann

// Light for scenes that bring none of their own.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

/// Lights a scene that is lit too little to be seen by that integrator, as `lippmann render` does. Paths: the built-in studio
/// where nothing gives light, and where walls around the viewer keep that out a lamp at the viewer; a dim studio around lamps
/// that stand in darkness. Whitted's shading: a key light and a dim background where there is no lamp. All that is there stays,
/// and a scene with light and surroundings stays as it is. The light lies as the first camera sees it. Returns one sentence:
/// which light was taken, and why. Throws Error as validate(scene) does.
std::string add_missing_light(Scene& scene, Integrator integrator);

}  // namespace lippmann

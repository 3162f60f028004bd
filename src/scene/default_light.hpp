// Light for scenes whose file brings none.
#pragma once

#include "scene/scene.hpp"

namespace lippmann {

/// Whether light would change what the scene shows, but no lamp is there to give it. Emission counts as light where the
/// integrator carries it.
bool lacks_light(const Scene& scene, bool emission_lights);

/// A key light from above left of the viewer and a dim background. The viewer is the first camera, or has the default view.
void add_default_light(Scene& scene);

}  // namespace lippmann

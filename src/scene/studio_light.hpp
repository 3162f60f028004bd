// The built-in studio: a neutral panorama of soft boxes, for scenes whose file has no lights or no environment.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Studio strength for files that have lamps: enough for reflections, with dark shadows.
inline constexpr float kDimStudio = 0.08f;

/// Returns a grey panorama for a viewer who looks along -z: a key light behind the viewer's left shoulder, a weaker fill light
/// on the right, a soft box above and behind the subject, grey walls and a darker floor. White diffuse surfaces of any
/// orientation stay within display white. `viewer` rotates -z and y to the view direction and the top of the picture; the
/// studio turns about y with the viewer.
EnvironmentMap studio_environment(const Quatf& viewer);

}  // namespace lippmann

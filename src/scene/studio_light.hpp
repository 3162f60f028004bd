// The built-in studio: a neutral panorama of soft boxes, for scenes whose file brings no light or no surroundings.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Share of the studio's light that surrounds files with lamps of their own: mirrors have something to show, shadows stay dark.
inline constexpr float kDimStudio = 0.08f;

/// A grey panorama for a viewer who looks along -z: a key light behind the viewer's left shoulder, a weaker fill light on the
/// right, a soft box above and behind what is shown, grey walls and a darker floor. A white diffuse surface shows at most
/// display white, wherever it faces. `viewer` turns -z and y where the viewer looks; the studio turns about y with it.
EnvironmentMap studio_environment(const Quatf& viewer);

}  // namespace lippmann

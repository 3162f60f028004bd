// The built-in studio: a neutral panorama of soft boxes for scenes whose file has no lights or no environment.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Strength of the studio for files that have lamps: visible in reflections, but weak enough for dark shadows.
inline constexpr float kDimStudio = 0.08f;

/// Returns a grey panorama for a viewer who looks along -z. It shows grey walls, a darker floor and three soft boxes: a key
/// light behind the viewer's left shoulder, a weaker fill light on the right, and a light above and behind the subject. White
/// diffuse surfaces of any orientation stay within display white.
///
/// `viewer` is the viewer's rotation: it turns -z to the view direction and y to the top of the picture. The studio turns with
/// the viewer about the y axis only.
EnvironmentMap studio_environment(const Quatf& viewer);

}  // namespace lippmann

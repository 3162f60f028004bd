#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Strength of the studio for files that have lamps: visible in reflections, but weak enough for dark shadows.
inline constexpr float kDimStudio = 0.08f;

/// Returns a grey panorama for a viewer who looks along -z: grey walls, a darker floor and three soft boxes. White diffuse
/// surfaces of any orientation stay within display white.
///
/// `viewer` is the viewer's rotation: it turns -z to the view direction and y to the top of the picture. The studio turns with
/// the viewer about the y axis only.
EnvironmentMap studio_environment(const Quatf& viewer);

}  // namespace lippmann

#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns whether some surface needs lamps but the scene has none, or only black ones. Emissive glTF surfaces do not count as
/// lamps because Whitted shading ignores their light. Phong surfaces with ambient light do not need lamps.
bool lacks_lamps(const Scene& scene);

/// Adds a directional light from above left of the viewer, and a dim background if the background is black. The viewer is the
/// first camera, or the default view.
void add_default_light(Scene& scene);

/// Returns the rotation that turns -z to the view direction, and y to the top of the picture, for the first camera or the
/// default view.
Quatf viewer_orientation(const Scene& scene);

enum class OwnLight {
  kNone,
  /// Lamps, or emissive surfaces that count as lamps. The background is black.
  kLamps,
  kSurroundings,
  kNotNeeded,
};

/// Classifies the light of a scene for path tracing. Emissive glTF surfaces without textures count as lamps if their emission,
/// averaged over the area of all surfaces, is at least 0.02. Emissive Phong surfaces and backdrops always count.
OwnLight own_light(const Scene& scene);

}  // namespace lippmann

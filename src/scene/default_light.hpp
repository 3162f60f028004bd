// Default light for scenes whose file has no lights.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns whether some surface needs light and the scene has no lamps, or only black ones. Emissive glTF surfaces do not count
/// because Whitted shading ignores their light. Phong surfaces with ambient light do not need lamps, however dark they are.
bool lacks_lamps(const Scene& scene);

/// Adds a key light from above left of the viewer and, if the background is black, a dim background. The viewer is the first
/// camera or the default view.
void add_default_light(Scene& scene);

/// Returns the orientation of the first camera, or of the default view: the rotation that turns -z to the view direction and y
/// to the top of the picture.
Quatf viewer_orientation(const Scene& scene);

/// The light sources that path tracing finds in a scene.
enum class OwnLight {
  kNone,          ///< no light, but some surface needs it
  kLamps,         ///< lamps, or emissive surfaces large enough to act as lamps, in front of a black background
  kSurroundings,  ///< a panorama or a sky, with or without lamps
  kNotNeeded,     ///< no light, and light would not change any surface
};

/// Returns the kind of light in a scene. Emissive glTF surfaces act as lamps if their emission, averaged over the area of all
/// surfaces, is at least 0.02; emissive textures do not count. Weaker emission (a car's tail lights) does not illuminate the
/// scene, and textures are usually decoration. Emissive Phong surfaces and backdrops are lamps of any size because their
/// authors have lit the scene.
OwnLight own_light(const Scene& scene);

}  // namespace lippmann

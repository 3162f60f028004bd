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

/// Returns the orientation of the first camera, or of the default view: the rotation of -z and y to its view direction and its
/// top.
Quatf viewer_orientation(const Scene& scene);

/// The light sources that path tracing finds in a scene.
enum class OwnLight {
  kNone,          ///< none, but some surface needs light
  kLamps,         ///< lamps, or emissive surfaces large enough to act as lamps, in front of a black background
  kSurroundings,  ///< a panorama or a sky, with or without lamps
  kNotNeeded,     ///< none, and light would not change any surface
};

/// Returns the kind of light in a scene. Emissive glTF surfaces act as lamps if the emission of uniformly coloured ones,
/// averaged over the area of all surfaces, is at least 0.02. Weaker emission (a car's tail lights) does not illuminate the
/// scene, and emissive textures are treated as decoration. Emissive Phong surfaces and backdrops are lamps of any size because
/// their authors have lit the scene.
OwnLight own_light(const Scene& scene);

}  // namespace lippmann

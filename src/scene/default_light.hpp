// Classifies the light of a scene, and adds a default light to scenes whose file has none.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns whether some surface needs lamps but the scene has none, or only black ones. Emissive glTF surfaces do not count as
/// lamps because Whitted shading ignores their light. Phong surfaces with ambient light do not need lamps, however dark they
/// are.
bool lacks_lamps(const Scene& scene);

/// Adds a directional light from above left of the viewer. Also adds a dim background if the background is black. The viewer is
/// the first camera, or the default view if there is no camera.
void add_default_light(Scene& scene);

/// Returns the orientation of the first camera, or of the default view if there is no camera. This rotation turns -z to the
/// view direction, and y to the top of the picture.
Quatf viewer_orientation(const Scene& scene);

/// The light sources that path tracing finds in a scene.
enum class OwnLight {
  kNone,  ///< no light, although some surface needs it
  /// Lamps, or emissive surfaces that count as lamps. The background is black.
  kLamps,
  kSurroundings,  ///< a panorama or a sky; the scene may also have lamps
  kNotNeeded,     ///< no surface needs light
};

/// Classifies the light of a scene for path tracing. Emissive glTF surfaces count as lamps if their emission, averaged over the
/// area of all surfaces, is at least 0.02. Weaker emission, such as that of a car's tail lights, does not illuminate the scene.
/// Emissive textures do not count because most of them are decoration. Emissive Phong surfaces and backdrops count at any size
/// because scenes that use them were lit by their authors.
OwnLight own_light(const Scene& scene);

}  // namespace lippmann

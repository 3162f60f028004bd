// Moves scenes that lie far from their coordinate origin, such as buildings in map coordinates.
//
// A float has a 24-bit significand. An image of 4,096 pixels that shows the whole scene needs 12 bits to distinguish pixels, 4
// more for a sixteenth of a pixel, and 2 for rounding errors of a few transforms. That leaves 6 bits: a scene whose centre is
// more than 2^6 times its diagonal away from the origin gets its own origin, Scene::origin. The same applies if only a group of
// instances is that far away, provided that this group is larger than all other instances together, for example a building on a
// map with a marker at the map's origin. Other scenes stay unchanged.
#pragma once

#include <optional>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns the origin that a scene should get, in its present coordinates: near the centre of the distant instances at frame 0,
/// rounded to few binary digits. Returns none if the scene is close enough to its origin or has no bounds. All indices of the
/// scene must be valid.
std::optional<Vec3d> distant_origin(const Scene& scene);

/// Gives a distant scene an origin near its centre, and changes nodes, shapes, skins and animations so that everything keeps
/// its position up to float precision. load_scene() calls this; call it for scenes built in memory before place() and Renderer.
/// Scenes with projected textures (ImageProjection) stay unchanged. Throws Error if the scene fails validate().
void move_near_origin(Scene& scene);

}  // namespace lippmann

// Moves the origin of scenes that lie far from it, such as buildings in map coordinates, because floats are too coarse there.
//
// A scene is far from the origin if its centre is more than 2^6 of its diagonals away. Such a scene gets its own origin,
// Scene::origin. The limit follows from the 24-bit significand of a float. An image of 4,096 pixels needs:
// - 12 bits to distinguish pixels,
// - 4 bits for positions of a sixteenth of a pixel,
// - 2 bits for the rounding errors of a few transforms.
//
// The other 24 - 12 - 4 - 2 = 6 bits are left for the distance from the origin.
//
// A scene also gets its own origin if only some of its instances are that far away, provided that together they are larger than
// all other instances.
#pragma once

#include <optional>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns the origin that a scene should get, in its present coordinates: the centre of the distant instances at frame 0,
/// rounded to few binary digits. Returns none if the scene is close enough to its origin or has no bounds. All indices of the
/// scene must be valid.
std::optional<Vec3d> distant_origin(const Scene& scene);

/// Gives a scene that is far from its origin a new origin near its centre, so that everything keeps its position up to float
/// precision. load_scene() calls this function. For scenes built in memory, call it before place() and before constructing a
/// Renderer. Scenes with projected textures (ImageProjection) stay unchanged. Throws Error if the scene fails validate().
void move_near_origin(Scene& scene);

}  // namespace lippmann

// Moves scenes that lie far from the origin of their coordinates, as those on a map do.
//
// A float has 24 bits. A picture of 4,096 pixels that shows all of the scene needs 12 of them to tell its pixels apart, 4 more
// for a sixteenth of a pixel, and 2 for the roundings of a few transforms. That leaves 6: a scene whose middle is more than
// 2^6 times its diagonal away from the origin gets an origin of its own, Scene::origin. So does one whose instances that are so
// far away are so together, and extend farther than all others together: a building on a map, and a marker at its origin. All
// others stay as they are.
#pragma once

#include <optional>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The origin that a scene should have at frame 0, in its present coordinates: near the middle of what is far away, with few
/// binary digits. None:
/// it is near enough to its origin, or has no bounds. The scene must have valid indices.
std::optional<Vec3d> distant_origin(const Scene& scene);

/// Gives a scene that needs it an origin near its middle, and changes nodes, shapes, skins and animations so that everything
/// stands where it stood, as exactly as its floats say. load_scene() has done so; scenes that are built in memory may need it
/// before place() and Renderer. Scenes with projected textures (ImageProjection) stay as they are. Throws Error as validate().
void move_near_origin(Scene& scene);

}  // namespace lippmann

// Light for scenes whose file brings none.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Whether light would change what the scene shows, but no lamp is there to give it, or black ones alone. Emission of glTF's
/// surfaces counts for nothing: Whitted's shading carries it nowhere. A Phong surface with ambient light is as dark as its
/// author made it.
bool lacks_lamps(const Scene& scene);

/// A key light from above left of the viewer and, where all is dark, a dim background. The viewer is the first camera, or has
/// the default view.
void add_default_light(Scene& scene);

/// How the viewer is turned: -z and y go where the first camera looks and has its top, or as in the default view.
Quatf viewer_orientation(const Scene& scene);

/// What paths find that gives light in a scene.
enum class OwnLight {
  kNone,          ///< nothing, but surfaces wait for it
  kLamps,         ///< lamps, or surfaces that shine as lamps do; what misses all surfaces finds darkness
  kSurroundings,  ///< a panorama or a sky, with or without lamps
  kNotNeeded,     ///< no surface would look different
};

/// Surfaces shine as lamps do where they matter: what those of one colour emit, on average over the area of all surfaces, is at
/// least 0.02. Weaker glow (the tail lights of a car) lights nothing, and pictures that shine are taken for decoration. Phong
/// surfaces that emit, or shine as backdrops do, are lamps whatever their size: their authors have lit the scene.
OwnLight own_light(const Scene& scene);

}  // namespace lippmann

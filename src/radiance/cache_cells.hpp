// Where points of surfaces find their cells of the radiance cache, in updates and look-ups alike.
#pragma once

#include "radiance/surface_places.hpp"
#include "shading/light_table.hpp"

namespace lippmann {

/// How points of surfaces find their cells, in updates and look-ups alike.
struct CacheCells {
  const SurfacePlaces& places;
  const BeamFootprint& beam;
  float samples_per_cell = 8.0f;                ///< across the smallest cell
  LightGroup lights_from = LightGroup::kLamps;  ///< groups of lights from here on; those before it are asked at every point
  /// Edge of the smallest cell at the end of a path of some length, world units.
  float size(float path_length) const;
};

}  // namespace lippmann

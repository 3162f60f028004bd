// Adjusts shading normals so that mirror directions leave the surface.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns `normal` if it mirrors `view` to a direction above the facet, otherwise the nearest such normal between `normal` and
/// the facet's normal. normal and view have unit length. facet has any length and points to the viewer's side.
Vec3f lifted_normal(Vec3f normal, Vec3f facet, Vec3f view);

}  // namespace lippmann

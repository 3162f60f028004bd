#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Flips each triangle that faces away from the mean of its three vertex normals. Otherwise such triangles would get no direct
/// light, because shading uses the visible side of the facet.
void wind_by_normals(Mesh& mesh);

}  // namespace lippmann

// Aligns the winding of triangles with their vertex normals, for formats that define the outside by normals.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Flips each triangle that faces away from the mean of its three normals. Meshes without normals stay unchanged. Shading uses
/// the visible side of the facet, so triangles wound against their normals would get no direct light.
void wind_by_normals(Mesh& mesh);

}  // namespace lippmann

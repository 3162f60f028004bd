// Makes the winding of triangles agree with their vertices' normals, for formats whose files say by normals where outside is.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Turns over each triangle that faces away from the mean of its three normals; does nothing to meshes without normals.
/// Shading takes the side of the facet that is seen, so a triangle wound against its normals would get no direct light.
void wind_by_normals(Mesh& mesh);

}  // namespace lippmann

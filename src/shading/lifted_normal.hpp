// Normals whose mirror direction leaves the surface.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// `normal` where the mirror direction of `view` about it is above the facet, else the one nearest to it, between it and the
/// facet's, for which that is so. Seen edge-on, a smooth or bent normal mirrors the view into the surface, which would be black
/// there. normal, view: unit length; facet: of any length, on the viewer's side.
Vec3f lifted_normal(Vec3f normal, Vec3f facet, Vec3f view);

}  // namespace lippmann

// Normalises the direction vectors of scene files and converts them to view rotations.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns v with unit length. Uses double precision so that the squared length neither overflows nor underflows.
Vec3f direction_of(Vec3f v);

/// Returns the rotation of a node whose -z points along `forward` and whose +y is as close to `up` as possible. Both vectors
/// must be non-zero and not parallel, in right-handed coordinates.
Quatf looking_along(Vec3f forward, Vec3f up);

}  // namespace lippmann

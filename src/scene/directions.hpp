// Unit vectors and view rotations from vectors of any length, as in scene files.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns the unit vector. It is computed in double so that any finite non-zero vector works.
Vec3f direction_of(Vec3f v);

/// Returns the rotation of a node whose -z points along `forward` and whose +y is as close to `up` as possible. `forward` and
/// `up` belong to a right-handed frame, are non-zero and not parallel.
Quatf looking_along(Vec3f forward, Vec3f up);

}  // namespace lippmann

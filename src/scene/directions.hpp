// Directions and the rotations that look along them, from vectors of any length as files have them.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// A unit vector of the same direction, computed in double so that any finite vector that is not zero has one.
Vec3f direction_of(Vec3f v);

/// The rotation of a node whose -z looks along `forward` and whose +y lies in the plane of `forward` and `up`, on up's side.
/// Both right-handed, not parallel, not zero.
Quatf looking_along(Vec3f forward, Vec3f up);

}  // namespace lippmann

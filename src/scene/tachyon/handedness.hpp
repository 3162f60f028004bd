// Converts Tachyon's left-handed world to our right-handed one by mirroring everything in the plane z = 0.
//
// Tachyon's camera has right = up x view. The mirror M = diag(1, 1, -1) turns that into right = view x up, as in our cameras,
// because M(a x b) = -(Ma x Mb). So the picture does not change. For the same reason, two corners of each triangle must be
// swapped to keep the side of its geometric normal (v1 - v0) x (v2 - v0).
// Distances, angles and the dot products of image maps do not change either.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann::tachyon {

inline Vec3f mirrored(Vec3f v) { return {v.x, v.y, -v.z}; }

}  // namespace lippmann::tachyon

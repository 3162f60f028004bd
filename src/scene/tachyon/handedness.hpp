// Carries Tachyon's left-handed world over into our right-handed one: everything is mirrored in the plane z = 0.
//
// Tachyon's camera has right = up x view. Mirroring M = diag(1, 1, -1) turns that into right = view x up, as our cameras have
// it, because M(a x b) = -(Ma x Mb); so a scene, its camera and its picture stay the same. For the same reason a triangle's
// geometric normal (v1 - v0) x (v2 - v0) keeps its side only if two of its corners change places.
// Distances, angles and u.p products (image maps) do not change.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann::tachyon {

inline Vec3f mirrored(Vec3f v) { return {v.x, v.y, -v.z}; }

}  // namespace lippmann::tachyon

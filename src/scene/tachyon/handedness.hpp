// Converts Tachyon's left-handed world to our right-handed world by mirroring everything in the plane z = 0.
//
// The mirror M = diag(1, 1, -1) turns Tachyon's camera, with right = up x view, into ours, with right = view x up, because M(a
// x b) = -(Ma x Mb).
//
// For the same reason, the mirror flips the geometric normal (v1 - v0) x (v2 - v0) of a triangle, so two of its corners must be
// swapped.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann::tachyon {

inline Vec3f mirrored(Vec3f v) { return {v.x, v.y, -v.z}; }

}  // namespace lippmann::tachyon

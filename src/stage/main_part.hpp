// Finds the main part of a scene whose parts are so far apart that an image of everything would show nothing.
//
// 1. Find the widest gap between parts along an axis of the bounding box. Cut the box in the middle of this gap.
// 2. Drop the side with less surface area. Repeat step 1 with the other side.
// 3. The cuts apply if the remaining part is small relative to the narrowest gap, so that it would fill less than 1/20 of the
//    image's width. Otherwise the scene stays whole.
// Long thin triangles (slivers), whose common vertex may be far away, do not close gaps.
#pragma once

#include <optional>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct ScenePiece {
  Bounds3f bounds;
  float area = 0.0f;
  bool is_sliver = false;
};

ScenePiece piece_of_triangle(Vec3f a, Vec3f b, Vec3f c);

/// Returns a box around the main part, whose sides cross only slivers. Returns nothing if the scene stays whole.
std::optional<Bounds3f> find_main_part(std::vector<ScenePiece> pieces);

}  // namespace lippmann

// Finds the main part of a scene whose parts are so far apart that an image of everything would show nothing.
//
// Based on gaps: the bounding box is cut in the middle of the widest gap along an axis, and the side with less surface is
// dropped; then the remaining box is cut again. The cuts apply if the remaining part is so small relative to the narrowest gap
// that it would fill less than 1/20 of the image's width. Otherwise the scene is whole. Slivers, which a stray vertex makes of
// adjacent triangles, do not close gaps.
#pragma once

#include <optional>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct ScenePiece {
  Bounds3f bounds;
  float area = 0.0f;  ///< approximate surface area
  bool is_sliver = false;
};

ScenePiece piece_of_triangle(Vec3f a, Vec3f b, Vec3f c);

/// Returns a box around the main part, which cuts no other pieces except slivers. Returns nothing if the scene is whole.
std::optional<Bounds3f> find_main_part(std::vector<ScenePiece> pieces);

}  // namespace lippmann

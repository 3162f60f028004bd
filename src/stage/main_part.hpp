// Which part of a scene a view is about, where others lie so far away that a picture of all would show nothing of any.
//
// Based on gaps: the box around all is cut in the middle of the widest gap along an axis, and the side with less surface is
// left out; the same again with what remains. The cuts count once what remains is so small beside the narrowest gap that it
// would fill less than 1/20 of the picture's width. A scene whose parts lie closer together is whole. Slivers,
// which a stray vertex makes of the triangles around it, do not close gaps.
#pragma once

#include <optional>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct ScenePiece {
  Bounds3f bounds;
  float area = 0.0f;  ///< of its surface, about
  bool is_sliver = false;
};

ScenePiece piece_of_triangle(Vec3f a, Vec3f b, Vec3f c);

/// A box around the pieces that remain, which cuts none of the others but slivers; none where nothing is left out.
std::optional<Bounds3f> find_main_part(std::vector<ScenePiece> pieces);

}  // namespace lippmann

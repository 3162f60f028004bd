// Where the light of paths goes, and what is kept beside it.
#pragma once

#include "shading/shading_point.hpp"

namespace lippmann {

/// What the camera rays' first surfaces are, weighted as their light: see NoisyFrame.
struct FirstSurfaces {
  float *albedo, *normal;                   ///< three channels
  float *z, *met;                           ///< one
  Vec4f display_z{0.0f, 0.0f, 0.0f, 0.0f};  ///< z in display mm = dot with (x, y, z, 1)

  void add(const ShadingPoint& point, Vec3f normal_there, std::size_t pixel, float weight) const;
};
/// The last row of the matrix from world to display.
Vec4f display_z(const Affine3f& world_from_display);

/// Three channels a pixel each, unless stated otherwise; null: nowhere.
struct PathFilm {
  float* all = nullptr;
  float* direct = nullptr;    ///< what shines by itself, and what one surface has scattered
  float* indirect = nullptr;  ///< the rest
  float* noise = nullptr;     ///< NoisyFrame::noise
  float* seen = nullptr;      ///< what has met no surface, or shines from the first
  const FirstSurfaces* surfaces = nullptr;
  float* open = nullptr;  ///< one channel: how many samples would see the surroundings, which they then do not
};

}  // namespace lippmann

#pragma once

#include "shading/shading_point.hpp"

namespace lippmann {

struct FirstSurfaces {
  float *albedo, *normal;
  float *z, *met;
  Vec4f display_z{0.0f, 0.0f, 0.0f,
                  0.0f};  ///< The z of a point, in mm of the display frame, is the dot product of display_z and (x, y, z, 1).

  void add(const ShadingPoint& point, Vec3f normal_there, std::size_t pixel, float weight) const;
};
Vec4f display_z(const Affine3f& world_from_display);

/// Output arrays with three channels per pixel, except for `open`. Null outputs are not computed.
struct PathFilm {
  float* all = nullptr;
  float* direct = nullptr;    ///< emission, and light that exactly one surface has scattered
  float* indirect = nullptr;  ///< light that is not in `direct`
  float* noise = nullptr;     ///< see NoisyFrame::noise
  float* seen = nullptr;      ///< see NoisyFrame::seen
  const FirstSurfaces* surfaces = nullptr;
  float* open = nullptr;  ///< one channel: number of samples that hit no surface; if not null, the film omits the background
};

}  // namespace lippmann

// The outputs of path tracing: light and surface features per pixel.
#pragma once

#include "shading/shading_point.hpp"

namespace lippmann {

/// Sums of the features of the first surfaces on camera rays, with the same weights as the light; see NoisyFrame.
struct FirstSurfaces {
  float *albedo, *normal;                   ///< three channels
  float *z, *met;                           ///< one channel
  Vec4f display_z{0.0f, 0.0f, 0.0f, 0.0f};  ///< z in display mm = dot(display_z, (x, y, z, 1))

  void add(const ShadingPoint& point, Vec3f normal_there, std::size_t pixel, float weight) const;
};
/// Returns the row of the world-to-display matrix that yields z.
Vec4f display_z(const Affine3f& world_from_display);

/// Output arrays with three channels per pixel unless stated otherwise. A null pointer disables an output.
struct PathFilm {
  float* all = nullptr;
  float* direct = nullptr;    ///< emission, and light that one surface has scattered
  float* indirect = nullptr;  ///< all other light
  float* noise = nullptr;     ///< NoisyFrame::noise
  float* seen = nullptr;      ///< background, and emission of the first surface
  const FirstSurfaces* surfaces = nullptr;
  float* open = nullptr;  ///< one channel: number of samples that miss all surfaces; if set, the film omits the surroundings
};

}  // namespace lippmann

// How a model hands over a ray: where its line crosses the plane z = z_front and how steeply, and from there the ray in world
// space. One inline function for the single ray and for the vectorised loops, so that both give the same bits.
#pragma once

#include "core/math.hpp"
#include "core/multiversion.hpp"
#include "optics/optics.hpp"

namespace lippmann {

/// A line in the display frame.
struct Crossing {
  float x, y;              ///< mm, in the plane z = z_front
  float slope_x, slope_y;  ///< dx/dz, dy/dz
};

/// Takes lines to rays in another frame by a similarity (a rotation, one scale, a translation).
struct RayFrame {
  Vec3f origin{0.0f};                                   ///< world position of (0, 0, z_front)
  Vec3f right{1.0f, 0.0f, 0.0f}, up{0.0f, 1.0f, 0.0f};  ///< world vectors of 1 mm along x and y
  Vec3f unit_right{1.0f, 0.0f, 0.0f}, unit_up{0.0f, 1.0f, 0.0f}, unit_forward{0.0f, 0.0f, -1.0f};  ///< forward: display -z
};

/// The frame for lines that are given at z = z_front.
RayFrame make_ray_frame(const Affine3f& world_from_display, float z_front_mm);

/// Writes ray i: it starts in the plane z = z_front and runs towards -z; unit direction.
LIPPMANN_INLINE void write_ray(const RayFrame& frame, const Crossing& line, const RayArrays& rays, int i) {
  // Display direction: (-slope_x, -slope_y, -1), normalised; its -1 is along `unit_forward`.
  const float inverse_length = 1.0f / std::sqrt(line.slope_x * line.slope_x + line.slope_y * line.slope_y + 1.0f);
  const float dx = -line.slope_x * inverse_length, dy = -line.slope_y * inverse_length;
  rays.origin_x[i] = frame.origin.x + (line.x * frame.right.x + line.y * frame.up.x);
  rays.origin_y[i] = frame.origin.y + (line.x * frame.right.y + line.y * frame.up.y);
  rays.origin_z[i] = frame.origin.z + (line.x * frame.right.z + line.y * frame.up.z);
  rays.direction_x[i] = dx * frame.unit_right.x + dy * frame.unit_up.x + inverse_length * frame.unit_forward.x;
  rays.direction_y[i] = dx * frame.unit_right.y + dy * frame.unit_up.y + inverse_length * frame.unit_forward.y;
  rays.direction_z[i] = dx * frame.unit_right.z + dy * frame.unit_up.z + inverse_length * frame.unit_forward.z;
}

}  // namespace lippmann

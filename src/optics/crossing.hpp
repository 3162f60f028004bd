// Converts lines in the display frame to world-space rays, which start in the plane z = z_front. Single rays and vectorised
// loops use the same inline functions, so that both give identical bits.
#pragma once

#include <algorithm>
#include <cstring>

#include "core/multiversion.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct Crossing {
  float x, y;
  float slope_x, slope_y;
};

/// A similarity transform from lines in the display frame to rays in world space.
struct RayFrame {
  Vec3f origin{0.0f};
  Vec3f right{1.0f, 0.0f, 0.0f}, up{0.0f, 1.0f, 0.0f};
  Vec3f unit_right{1.0f, 0.0f, 0.0f}, unit_up{0.0f, 1.0f, 0.0f}, unit_forward{0.0f, 0.0f, -1.0f};
  Vec3f forward{0.0f, 0.0f, -1.0f};  ///< world vector that corresponds to 1 mm along -z
};

RayFrame make_ray_frame(const Affine3f& world_from_display, float z_front_mm);

LIPPMANN_INLINE void write_ray(const RayFrame& frame, const Crossing& line, const RayArrays& rays, int i) {
  const float sx = line.slope_x, sy = line.slope_y, inverse_length = 1.0f / std::sqrt(sx * sx + sy * sy + 1.0f);
  rays.origin_x[i] = frame.origin.x + (line.x * frame.right.x + line.y * frame.up.x);
  rays.origin_y[i] = frame.origin.y + (line.x * frame.right.y + line.y * frame.up.y);
  rays.origin_z[i] = frame.origin.z + (line.x * frame.right.z + line.y * frame.up.z);
  rays.direction_x[i] = (frame.unit_forward.x - (sx * frame.unit_right.x + sy * frame.unit_up.x)) * inverse_length;
  rays.direction_y[i] = (frame.unit_forward.y - (sx * frame.unit_right.y + sy * frame.unit_up.y)) * inverse_length;
  rays.direction_z[i] = (frame.unit_forward.z - (sx * frame.unit_right.z + sy * frame.unit_up.z)) * inverse_length;
}

/// Writes the ray of one panel point, for models that have a function crossing(constants, px, py).
template <class Rays>
LIPPMANN_INLINE void write_ray_of(const Rays& constants, const RayFrame& frame, float px, float py, const RayArrays& rays,
                                  int i) {
  write_ray(frame, crossing(constants, px, py), rays, i);
}

/// Number of pixels that one call of a ray function computes: one AVX-512 vector or two AVX2 vectors.
inline constexpr int kRayBlock = 16;

/// Writes the rays of kRayBlock pixels. line_of(px, py) is the model's inlined function that returns a Crossing. Call this from
/// a LIPPMANN_MULTIVERSION function.
template <class LineOf>
LIPPMANN_INLINE void write_ray_block(const RayFrame& frame, const float* px, const float* py, const RayArrays& rays,
                                     const LineOf& line_of) {
  // Without the local array, the compiler would assume that writing to `rays` changes the constants.
  alignas(64) float out[6][kRayBlock];
  for (int i = 0; i < kRayBlock; ++i)
    write_ray(frame, line_of(px[i], py[i]), {out[0], out[1], out[2], out[3], out[4], out[5]}, i);
  float* const to[6] = {rays.origin_x, rays.origin_y, rays.origin_z, rays.direction_x, rays.direction_y, rays.direction_z};
  for (int c = 0; c < 6; ++c) std::memcpy(to[c], out[c], sizeof(out[c]));
}

/// Writes any number of rays. write_block(px, py, rays) is a model's LIPPMANN_MULTIVERSION function for kRayBlock pixels. The
/// last block is padded by repeating the last pixel.
template <class WriteBlock>
void for_each_ray_block(const float* px, const float* py, int count, const RayArrays& rays, const WriteBlock& write_block) {
  const auto from = [&rays](int i) {
    return RayArrays{rays.origin_x + i,    rays.origin_y + i,    rays.origin_z + i,
                     rays.direction_x + i, rays.direction_y + i, rays.direction_z + i};
  };
  int i = 0;
  for (; i + kRayBlock <= count; i += kRayBlock) write_block(px + i, py + i, from(i));
  if (i == count) return;
  float x[kRayBlock], y[kRayBlock], out[6][kRayBlock];
  for (int k = 0; k < kRayBlock; ++k) x[k] = px[std::min(i + k, count - 1)], y[k] = py[std::min(i + k, count - 1)];
  write_block(x, y, {out[0], out[1], out[2], out[3], out[4], out[5]});
  const RayArrays to = from(i);
  float* const arrays[6] = {to.origin_x, to.origin_y, to.origin_z, to.direction_x, to.direction_y, to.direction_z};
  for (int c = 0; c < 6; ++c) std::copy_n(out[c], count - i, arrays[c]);
}

}  // namespace lippmann

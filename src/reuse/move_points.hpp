// Moves points to another moment. This is the inner loop of projection and sampling.
#pragma once

#include <cstring>

#include "core/multiversion.hpp"
#include "reuse/motion.hpp"

namespace lippmann {

/// Number of points processed together. The fixed length lets the compiler vectorise loops.
inline constexpr int kPointLanes = 16;

struct alignas(64) Positions {
  float x[kPointLanes], y[kPointLanes], z[kPointLanes];
};

/// For each point: -1 if the point stays exactly in place, otherwise 0.
struct alignas(64) StillLanes {
  std::int32_t lane[kPointLanes];
};

LIPPMANN_INLINE void move_alike(const GroupMotion& motion, Positions& p, StillLanes& still) {
  float m[12];
  std::memcpy(m, motion.rows.data(), sizeof(m));
  const std::int32_t all_still = motion.still ? -1 : 0;
  for (int i = 0; i < kPointLanes; ++i) {
    const float x = p.x[i], y = p.y[i], z = p.z[i];
    p.x[i] = m[0] * x + m[1] * y + m[2] * z + m[3];
    p.y[i] = m[4] * x + m[5] * y + m[6] * z + m[7];
    p.z[i] = m[8] * x + m[9] * y + m[10] * z + m[11];
    still.lane[i] = all_still;
  }
}

LIPPMANN_INLINE void move_each(const Motion& motion, const std::uint32_t* object, Positions& p, StillLanes& still) {
  const std::size_t objects = motion.group_of_object->size();
  const std::uint32_t* const groups = motion.group_of_object->data();
  for (int i = 0; i < kPointLanes; ++i) {
    const GroupMotion& group = motion.groups[groups[object[i] < objects ? object[i] : 0]];
    const std::array<float, 12>& m = group.rows;
    const float x = p.x[i], y = p.y[i], z = p.z[i];
    p.x[i] = m[0] * x + m[1] * y + m[2] * z + m[3];
    p.y[i] = m[4] * x + m[5] * y + m[6] * z + m[7];
    p.z[i] = m[8] * x + m[9] * y + m[10] * z + m[11];
    still.lane[i] = group.still ? -1 : 0;
  }
}

inline Vec3f moved_point(const Motion& motion, std::uint32_t object, Vec3f p) {
  const bool known = object < motion.group_of_object->size();
  const GroupMotion& group = motion.groups[motion.uniform() || !known ? 0 : (*motion.group_of_object)[object]];
  if (group.still) return p;
  const std::array<float, 12>& m = group.rows;
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
          m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

}  // namespace lippmann

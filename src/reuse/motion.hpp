// Computes how objects move between two moments, relative to the display. Objects that move together form a group, which has
// one transform.
//
// A point p (display mm at moment a) of an object on node n moves at moment b to
//   p' = display_from_world(b) world_from_n(b) n_from_world(a) world_from_display(a) p.
// The product is composed in double precision, because world coordinates may be large compared to a pixel. All static objects
// form one group. If only the camera moves, this group is the only one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "reuse/point_image.hpp"

namespace lippmann {

/// Assigns each object to the group that it moves with. Make this once per scene.
struct MotionGroups {
  /// Indexed by object: the instances, followed by the lights.
  std::vector<std::uint32_t> group_of_object;
  /// Node that moves each group. Group 0 holds the static objects; its entry is -1.
  std::vector<int> node_of_group;
};

/// Groups the objects of a scene. Does not support deforming meshes, so frames/frame_maker.cpp rejects them for interpolated
/// frames.
MotionGroups make_motion_groups(const Scene& scene);

struct GroupMotion {
  /// Rows of the 3x4 matrix that maps a point p to the moved point p'. Row x has entries 0 to 3, row y entries 4 to 7 and row z
  /// entries 8 to 11. The last entry of a row is the translation.
  std::array<float, 12> rows;
  /// True if p' = p exactly. Still points then keep their pixels despite rounding errors.
  bool still = false;
};

struct Motion {
  /// One entry per group. Has a single entry if all objects move together.
  std::vector<GroupMotion> groups;
  const std::vector<std::uint32_t>* group_of_object = nullptr;

  bool uniform() const { return groups.size() == 1; }
};

/// Returns the motion between two moments. The result refers to `groups`, which must outlive it.
Motion motion_between(const MotionGroups& groups, const Moment& from, const Moment& to);

}  // namespace lippmann

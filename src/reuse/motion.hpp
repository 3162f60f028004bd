// Computes how objects move between two moments, relative to the display. Objects that move together form a group, which has
// one transform.
//
// A point p (display mm at moment a) of an object on node n moves at moment b to
//   p' = display_from_world(b) world_from_n(b) n_from_world(a) world_from_display(a) p.
// The product is composed in double precision, because world coordinates may be large compared to a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "reuse/point_image.hpp"

namespace lippmann {

struct MotionGroups {
  /// Indexed by object: the instances, followed by the lights.
  std::vector<std::uint32_t> group_of_object;
  /// Node that moves each group; -1 for group 0, the static objects.
  std::vector<int> node_of_group;
};

/// Groups the objects of a scene by the node that moves them. Does not support deforming meshes.
MotionGroups make_motion_groups(const Scene& scene);

struct GroupMotion {
  std::array<float, 12> rows;
  /// True if p' = p exactly. Points then keep their pixels despite rounding errors.
  bool still = false;
};

struct Motion {
  std::vector<GroupMotion> groups;
  const std::vector<std::uint32_t>* group_of_object = nullptr;

  bool uniform() const { return groups.size() == 1; }
};

/// Returns the motion between two moments. `groups` must outlive the result.
Motion motion_between(const MotionGroups& groups, const Moment& from, const Moment& to);

}  // namespace lippmann

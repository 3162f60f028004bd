// Describes motion between two moments relative to the display, with one transform per group of objects that move together.
//
// A point p (display mm at moment a) of an object on node n moves at moment b to
//   p' = display_from_world(b) world_from_n(b) n_from_world(a) world_from_display(a) p.
// The product is composed in double precision, because the world may be large compared to a pixel. All static objects form one
// group. If only the camera moves, it is the only group.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "reuse/point_image.hpp"

namespace lippmann {

/// The groups of objects that move together. Make this once per scene.
struct MotionGroups {
  std::vector<std::uint32_t> group_of_object;  ///< indexed by object: first instances, then lights
  std::vector<int> node_of_group;              ///< group 0 is static and has -1
};

/// Groups the objects of a scene. Deforming meshes are not supported; frames/frame_maker.cpp rejects them for interpolated
/// frames.
MotionGroups make_motion_groups(const Scene& scene);

struct GroupMotion {
  std::array<float, 12> rows;  ///< p' = linear p + translation: x from entries 0 ... 2 and 3, y from 4 ... 7, z from 8 ... 11
  bool still = false;          ///< p' = p exactly: points stay in their pixels despite rounding
};

struct Motion {
  std::vector<GroupMotion> groups;  ///< one group if all objects move together
  const std::vector<std::uint32_t>* group_of_object = nullptr;

  bool uniform() const { return groups.size() == 1; }
};

/// Returns the motion from one moment to another. `groups` must outlive the result.
Motion motion_between(const MotionGroups& groups, const Moment& from, const Moment& to);

}  // namespace lippmann

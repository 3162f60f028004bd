// The known motion from one moment to another, as seen from the display: one transform for all objects that move alike.
//
// A point p (display mm at moment a) of an object on node n is, at moment b, at
//   p' = display_from_world(b) world_from_n(b) n_from_world(a) world_from_display(a) p,
// composed in double precision, because the world may be large beside a pixel. What stands still is one group, whatever node it
// is on; if only the camera moves, there is no other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "reuse/point_image.hpp"

namespace lippmann {

/// Which objects of a scene move alike. Made once per scene.
struct MotionGroups {
  std::vector<std::uint32_t> group_of_object;  ///< by object: instances, then lights
  std::vector<int> node_of_group;              ///< group 0 stands still: -1
};

/// Meshes that change their shape are not carried right: what interpolates frames refuses them (frames/frame_maker.cpp).
MotionGroups make_motion_groups(const Scene& scene);

struct GroupMotion {
  std::array<float, 12> rows;  ///< p' = linear p + translation: x from entries 0 ... 2 and 3, y from 4 ... 7, z from 8 ... 11
  bool still = false;          ///< p' = p: points stay in their pixels, whatever rounding would make of them
};

struct Motion {
  std::vector<GroupMotion> groups;  ///< one where everything moves alike
  const std::vector<std::uint32_t>* group_of_object = nullptr;

  bool uniform() const { return groups.size() == 1; }
};

/// `groups` must outlive the result.
Motion motion_between(const MotionGroups& groups, const Moment& from, const Moment& to);

}  // namespace lippmann

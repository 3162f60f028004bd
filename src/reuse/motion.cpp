#include "reuse/motion.hpp"

#include <algorithm>

#include "core/affine3d.hpp"

namespace lippmann {
namespace {

GroupMotion to_group_motion(const Affine3d& a) {
  GroupMotion motion;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) motion.rows[static_cast<std::size_t>(4 * r + c)] = static_cast<float>(a.linear[c][r]);
    motion.rows[static_cast<std::size_t>(4 * r + 3)] = static_cast<float>(a.translation[r]);
  }
  return motion;
}

GroupMotion display_motion(const Affine3d& world, const Moment& from, const Moment& to) {
  if (world == Affine3d{} && from.world_from_display == to.world_from_display) {
    GroupMotion still = to_group_motion({});
    still.still = true;
    return still;
  }
  return to_group_motion(inverse(to_double(to.world_from_display)) * world * to_double(from.world_from_display));
}

}  // namespace

MotionGroups make_motion_groups(const Scene& scene) {
  const std::vector<bool> moves = moving_nodes(scene);
  MotionGroups groups{{}, {-1}};
  std::vector<std::uint32_t> group_of_node(scene.nodes.size(), 0);
  const auto add = [&](int node) {
    const auto n = static_cast<std::size_t>(node);
    if (node < 0 || !moves[n]) return groups.group_of_object.push_back(0);
    if (group_of_node[n] == 0) {
      group_of_node[n] = static_cast<std::uint32_t>(groups.node_of_group.size());
      groups.node_of_group.push_back(node);
    }
    groups.group_of_object.push_back(group_of_node[n]);
  };
  for (const Instance& instance : scene.instances) add(instance.node);
  for (const Light& light : scene.lights) add(light.node);
  if (groups.group_of_object.empty()) groups.group_of_object.push_back(0);
  return groups;
}

Motion motion_between(const MotionGroups& groups, const Moment& from, const Moment& to) {
  Motion motion;
  motion.group_of_object = &groups.group_of_object;
  for (const int node : groups.node_of_group)
    motion.groups.push_back(display_motion(world_motion(from.resolved.of(node), to.resolved.of(node)), from, to));
  return motion;
}

}  // namespace lippmann

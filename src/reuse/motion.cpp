#include "reuse/motion.hpp"

#include <algorithm>

namespace lippmann {
namespace {

struct Affine3d {
  glm::dmat3 linear{1.0};
  glm::dvec3 translation{0.0};
};

Affine3d to_double(const Affine3f& a) { return {glm::dmat3(a.linear), glm::dvec3(a.translation)}; }

Affine3d operator*(const Affine3d& a, const Affine3d& b) {
  return {a.linear * b.linear, a.linear * b.translation + a.translation};
}

Affine3d inverse(const Affine3d& a) {
  const glm::dmat3 m = glm::inverse(a.linear);
  return {m, -(m * a.translation)};
}

/// Where a node has carried the world's points between two moments.
Affine3d world_motion(const Affine3f& from, const Affine3f& to) {
  return from == to ? Affine3d{} : to_double(to) * inverse(to_double(from));
}

GroupMotion to_group_motion(const Affine3d& a) {
  GroupMotion motion;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) motion.rows[static_cast<std::size_t>(4 * r + c)] = static_cast<float>(a.linear[c][r]);
    motion.rows[static_cast<std::size_t>(4 * r + 3)] = static_cast<float>(a.translation[r]);
  }
  return motion;
}

/// As the display sees it.
GroupMotion display_motion(const Affine3d& world, const Moment& from, const Moment& to) {
  const bool still_in_world = world.linear == glm::dmat3(1.0) && world.translation == glm::dvec3(0.0);
  if (still_in_world && from.world_from_display == to.world_from_display) {
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

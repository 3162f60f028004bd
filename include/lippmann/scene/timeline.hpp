// Evaluates the node hierarchy of a Scene at a given time.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// World transforms and morph weights of all nodes of a scene at one time, indexed like Scene::nodes.
struct ResolvedScene {
  std::vector<Affine3f> world_from_node{};
  std::vector<std::vector<float>> morph_weights{};  ///< one list per node; empty if no node has morph weights
  /// Returns the transform of a node, or the identity for node -1.
  Affine3f of(int node) const { return node < 0 ? Affine3f{} : world_from_node[static_cast<std::size_t>(node)]; }
};

/// Returns the state of all nodes at a time in seconds. Equal times give the same bits. Throws Error if a node does not come
/// after its parent, or if an animated node does not exist. Cubic splines follow glTF 2.0, appendix C.
///
/// The scene must satisfy all other conditions of validate() (scene/load.hpp), here and in all functions below.
ResolvedScene evaluate(const Scene& scene, double time);

/// Returns for each node whether it or one of its ancestors has an animation with more than one value.
std::vector<bool> moving_nodes(const Scene& scene);

/// Returns whether every key of the animation falls on a frame at the given rate, within a fiftieth of a frame. Returns true if
/// the animation has no keys.
bool keys_fall_on_frames(const Timeline& timeline, double frames_per_second);

/// Returns for each node whether its morph weights ever change.
std::vector<bool> morphing_nodes(const Scene& scene);

/// Returns the bounds of all shapes except planes at one time, in the coordinates that frame_from_world maps to. Returns empty
/// bounds if there are no such shapes. Ignores outlying splats (bulk_bounds() in scene/splats.hpp).
Bounds3f finite_bounds(const Scene& scene, const ResolvedScene& resolved, const Affine3f& frame_from_world = {});

/// Returns the exact bounds of one instance in the coordinates that frame_from_world maps to.
Bounds3f finite_bounds(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                       const Affine3f& frame_from_world = {});

}  // namespace lippmann

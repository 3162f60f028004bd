// Evaluates the node hierarchy of a Scene at a given time.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The world transform and the morph weights of every node of a scene at one time, indexed as in Scene::nodes.
struct ResolvedScene {
  std::vector<Affine3f> world_from_node{};
  std::vector<std::vector<float>> morph_weights{};  ///< one list per node; empty: no node has morph weights
  /// Returns the transform of a node; the identity for -1.
  Affine3f of(int node) const { return node < 0 ? Affine3f{} : world_from_node[static_cast<std::size_t>(node)]; }
};

/// Evaluates all nodes at a time in seconds. Equal times give equal bits. Throws Error if a node's parent does not come before
/// it or an animated node does not exist. Otherwise, all functions in this header need a scene that passes validate()
/// (scene/load.hpp). Cubic splines follow glTF 2.0, appendix C ("Animation sampler interpolation modes").
ResolvedScene evaluate(const Scene& scene, double time);

/// Returns for each node whether it ever moves: it or one of its ancestors is animated with more than one value.
std::vector<bool> moving_nodes(const Scene& scene);

/// Returns whether every key of the animation falls on a frame at this frame rate, within a fiftieth of a frame. True if there
/// are no keys.
bool keys_fall_on_frames(const Timeline& timeline, double frames_per_second);

/// Returns for each node whether its morph weights ever change.
std::vector<bool> morphing_nodes(const Scene& scene);

/// Returns the bounds of all finite shapes (that is, without planes) at one time, along the axes of the world or of another
/// frame. Empty if there are no finite shapes. Outlying splats are ignored.
Bounds3f finite_bounds(const Scene& scene, const ResolvedScene& resolved, const Affine3f& frame_from_world = {});

/// Returns the bounds of one instance. They are exact in any affine frame, including sheared ones.
Bounds3f finite_bounds(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                       const Affine3f& frame_from_world = {});

}  // namespace lippmann

// Where everything is at a given time: evaluates the node hierarchy of a Scene.
#pragma once

#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The world transform and the morph weights of every node of a scene at one time; index as in Scene::nodes.
struct ResolvedScene {
  std::vector<Affine3f> world_from_node;
  std::vector<std::vector<float>> morph_weights;  ///< as many as the node has; empty: no node has any
  /// The transform of a node; the identity for -1.
  Affine3f of(int node) const { return node < 0 ? Affine3f{} : world_from_node[static_cast<std::size_t>(node)]; }
};

/// Equal times give equal bits. Throws Error where a node's parent does not come before it or an animated node does not exist;
/// otherwise the scene must pass validate() (scene/load.hpp), as for all functions below. glTF 2.0, appendix C ("Animation
/// sampler interpolation modes"), for the cubic spline.
ResolvedScene evaluate(const Scene& scene, double time);

/// Whether each node ever moves (it or one of its ancestors is animated with more than one value).
std::vector<bool> moving_nodes(const Scene& scene);

/// Whether every key of the animation falls on a frame, to a fiftieth of one, at that many frames a second; true without keys.
bool keys_fall_on_frames(const Timeline& timeline, double frames_per_second);

/// Whether the morph weights of each node ever change.
std::vector<bool> morphing_nodes(const Scene& scene);

/// Bounds of everything finite (planes are left out) at one time, along the axes of the world or of another frame; empty if
/// there is nothing finite. Of splats, those that stray far from the others do not count.
Bounds3f finite_bounds(const Scene& scene, const ResolvedScene& resolved, const Affine3f& frame_from_world = {});

/// The same of one of the scene's instances. The bounds are exact in any affine frame, a sheared one too.
Bounds3f finite_bounds(const Scene& scene, const Instance& instance, const ResolvedScene& resolved,
                       const Affine3f& frame_from_world = {});

}  // namespace lippmann

// Computes world-space boxes around everything that moves during some frames of an animation.
//
// Meshes are divided into parts, and each part gets the box that it sweeps, so the boxes leave out space that a turning object
// does not pass through. Parts of deforming meshes that do not change have no box.
#pragma once

#include <span>
#include <vector>

#include "device/touched_blocks.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

class SweptBoxes {
 public:
  /// display_node: the node that carries the lens array, or -1. The scene must outlive this object.
  SweptBoxes(const Scene& scene, int display_node);

  /// Returns boxes that contain everything that moves between the first frame and the others of each horizon, at all of these
  /// frames. Horizon h has the frames first ... first + horizons[h] - 1, up to last_frame. The horizons must ascend from at
  /// least 2. A box applies to its horizon and all later ones. Changes that no box can bound (of the display, a light or an
  /// infinite plane) give an infinite box.
  std::vector<HorizonBox> around(int first, std::span<const int> horizons, int last_frame) const;

 private:
  struct MovingInstance {
    int node = -1;
    std::vector<Bounds3f> parts;  ///< in the space of the node
  };

  struct PosedInstance {
    std::size_t instance = 0;
    std::vector<std::vector<std::uint32_t>> parts;  ///< vertices of each part
  };

  void add_swept(const MovingInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  void add_swept(const PosedInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  bool all_changes(const ResolvedScene& from, const ResolvedScene& to) const;

  const Scene& scene_;
  std::vector<int> decisive_nodes_;  ///< moving nodes that carry the display, lights or infinite planes
  std::vector<MovingInstance> instances_;
  std::vector<PosedInstance> posed_;
};

}  // namespace lippmann

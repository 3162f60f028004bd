// Boxes around everything that moves during some frames of an animation, in world space.
//
// Meshes are bounded part by part, and every part by the box it sweeps: a turning object leaves free what it does not pass. Of
// meshes that change their shape, parts that stay as they are have no box.
#pragma once

#include <span>
#include <vector>

#include "device/touched_blocks.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

class SweptBoxes {
 public:
  /// display_node: what the lens array moves with; -1: nothing. The scene must outlive this.
  SweptBoxes(const Scene& scene, int display_node);

  /// Boxes that hold all that moves between the first frame and the others of each horizon, at all of these frames; horizon h:
  /// frames first ... first + horizons[h] - 1, as far as last_frame. horizons ascend, from 2. A box holds for its horizon and
  /// all later ones. From where on something changes that no box can bound (the display, a light, an infinite plane), a box
  /// without end.
  std::vector<HorizonBox> around(int first, std::span<const int> horizons, int last_frame) const;

 private:
  struct MovingInstance {
    int node = -1;
    std::vector<Bounds3f> parts;  ///< local to the node
  };

  struct PosedInstance {
    std::size_t instance = 0;
    std::vector<std::vector<std::uint32_t>> parts;  ///< the vertices of each
  };

  void add_swept(const MovingInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  void add_swept(const PosedInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  bool all_changes(const ResolvedScene& from, const ResolvedScene& to) const;

  const Scene& scene_;
  std::vector<int> decisive_nodes_;  ///< nodes that carry the display, lights or infinite planes, and move
  std::vector<MovingInstance> instances_;
  std::vector<PosedInstance> posed_;
};

}  // namespace lippmann

// Computes world-space boxes around everything that moves during some frames of an animation.
//
// Each part of a mesh gets a box around the space that it sweeps. Small parts give tight boxes around a turning object.
#pragma once

#include <span>
#include <vector>

#include "device/touched_blocks.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

class SweptBoxes {
 public:
  /// `display_node` is the node that carries the lens array, or -1. `scene` must outlive this object.
  SweptBoxes(const Scene& scene, int display_node);

  /// Returns boxes around everything that moves during the n frames from `first` on, but not after last_frame, for each n in
  /// `horizons`. Horizons ascend and are at least 2. HorizonBox::horizon is the index of the shortest horizon that needs the
  /// box. All longer horizons need the box too. A change of the display, a light or an infinite plane gives an infinite box.
  std::vector<HorizonBox> around(int first, std::span<const int> horizons, int last_frame) const;

 private:
  struct MovingInstance {
    int node = -1;
    std::vector<Bounds3f> parts;
  };

  struct PosedInstance {
    std::size_t instance = 0;
    std::vector<std::vector<std::uint32_t>> parts;
  };

  void add_swept(const MovingInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  void add_swept(const PosedInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  bool all_changes(const ResolvedScene& from, const ResolvedScene& to) const;

  const Scene& scene_;
  std::vector<int> decisive_nodes_;
  std::vector<MovingInstance> instances_;
  std::vector<PosedInstance> posed_;
};

}  // namespace lippmann

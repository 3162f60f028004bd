// Computes world-space boxes around everything that moves during some frames of an animation.
//
// A mesh is divided into parts. Each part gets a box around the space that it sweeps. Small parts give tight boxes: they
// exclude the space that a turning object does not pass through. Parts of a deforming mesh that do not change get no box.
#pragma once

#include <span>
#include <vector>

#include "device/touched_blocks.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

class SweptBoxes {
 public:
  /// `display_node` is the node that carries the lens array, or -1. The scene must outlive this object.
  SweptBoxes(const Scene& scene, int display_node);

  /// Returns boxes around everything that moves within a number of frames (a horizon), starting at frame `first`. Horizon h
  /// covers the frames first ... first + horizons[h] - 1, but none after last_frame. The horizons must ascend, and the lowest
  /// must be at least 2. Each box states the shortest horizon that it applies to, and applies to all longer horizons too. A
  /// change that no box can bound (of the display, a light or an infinite plane) gives an infinite box.
  std::vector<HorizonBox> around(int first, std::span<const int> horizons, int last_frame) const;

 private:
  struct MovingInstance {
    int node = -1;
    std::vector<Bounds3f> parts;  ///< bounds of each part, in the space of the node
  };

  struct PosedInstance {
    std::size_t instance = 0;
    std::vector<std::vector<std::uint32_t>> parts;  ///< vertex indices of each part
  };

  void add_swept(const MovingInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  void add_swept(const PosedInstance& instance, std::span<const ResolvedScene> moments, std::span<const int> horizons,
                 std::vector<HorizonBox>& boxes) const;
  bool all_changes(const ResolvedScene& from, const ResolvedScene& to) const;

  const Scene& scene_;
  /// Moving nodes that carry the display, a light or an infinite plane.
  std::vector<int> decisive_nodes_;
  std::vector<MovingInstance> instances_;
  std::vector<PosedInstance> posed_;
};

}  // namespace lippmann

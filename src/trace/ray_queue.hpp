// The queue of mirrored and transmitted rays of the next wave, in the order of their surfaces.
#pragma once

#include <memory>

#include "shading/surface.hpp"

namespace lippmann {

/// The state of the paths of a packet's lanes.
struct Bundle {
  Lanes3 weight;      ///< factor from a lane's radiance to its pixel
  Lanes path_length;  ///< distance from the path's start to the origin of the lane's ray
  Lanes open;         ///< share of a camera ray that has passed only holes; 0 after any other surface
  alignas(64) std::uint32_t pixel[kLanes];
};

/// The rays that continue from a packet of surface points: mirrored (entry = lane) and transmitted (entry = kLanes + lane).
struct Branches {
  static constexpr int kCount = 2 * kLanes;
  alignas(64) float dir_x[kCount], dir_y[kCount], dir_z[kCount];
  /// Share of the incoming radiance that is reflected or transmitted, per colour channel.
  alignas(64) float share_x[kCount], share_y[kCount], share_z[kCount];
  alignas(64) float open[kCount];  ///< factor for Bundle::open
};

/// A queue of rays with one array per quantity, so that packets are filled by plain copies.
class RayQueue {
 public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Appends the branches with the indices entry[0] to entry[count - 1]; count is at most Branches::kCount. `packet` and
  /// `bundle` are the rays that hit the surface.
  void append(const SurfacePacket& surface, const RayHitPacket& packet, const Bundle& bundle, const Branches& branches,
              const int* entry, int count);

  /// Loads a packet of rays, starting at ray `first`. Does not change the hits.
  void load(std::size_t first, RayHitPacket& packet, Bundle& bundle, LaneMask& active) const;

 private:
  static constexpr std::size_t kFields = 12;

  float* field(std::size_t index) const { return values_.get() + index * capacity_; }
  void grow();

  std::size_t size_ = 0, capacity_ = 0;
  std::unique_ptr<float[]> values_;  ///< kFields arrays of size capacity_: origin, direction, weight, path length, tnear, open
  std::unique_ptr<std::uint32_t[]> pixel_;
};

}  // namespace lippmann

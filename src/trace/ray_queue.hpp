// The queue of mirrored and transmitted rays that form the next wave.
#pragma once

#include <memory>

#include "shading/surface.hpp"

namespace lippmann {

/// The state of the paths of a packet, one path per lane.
struct Bundle {
  Lanes3 weight;      ///< factor on the radiance that the ray of a lane adds to its pixel
  Lanes path_length;  ///< path length at the origin of the lane's ray
  Lanes open;         ///< transmittance of a camera ray that has passed only surfaces made transparent by alpha; otherwise 0
  alignas(64) std::uint32_t pixel[kLanes];
};

/// The rays that continue from sixteen surface points. Entry `lane` is the mirrored ray, and entry kLanes + lane the
/// transmitted ray.
struct Branches {
  static constexpr int kCount = 2 * kLanes;
  alignas(64) float dir_x[kCount], dir_y[kCount], dir_z[kCount];
  /// Fraction of the radiance that is reflected or transmitted, per colour channel.
  alignas(64) float share_x[kCount], share_y[kCount], share_z[kCount];
  alignas(64) float open[kCount];
};

/// A queue of rays, with one array per quantity.
class RayQueue {
 public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Appends the branches entry[0] to entry[count - 1]. `packet` and `bundle` are the rays that hit the surface.
  void append(const SurfacePacket& surface, const RayHitPacket& packet, const Bundle& bundle, const Branches& branches,
              const int* entry, int count);

  void load(std::size_t first, RayHitPacket& packet, Bundle& bundle, LaneMask& active) const;

 private:
  static constexpr std::size_t kFields = 12;

  float* field(std::size_t index) const { return values_.get() + index * capacity_; }
  void grow();

  std::size_t size_ = 0, capacity_ = 0;
  std::unique_ptr<float[]> values_;
  std::unique_ptr<std::uint32_t[]> pixel_;
};

}  // namespace lippmann

// The rays of the next wave: what surfaces mirror and transmit, in the order in which they were met, until there are enough for
// full packets.
#pragma once

#include <memory>

#include "shading/surface.hpp"

namespace lippmann {

/// Where the lanes of a packet come from and go to.
struct Bundle {
  Lanes3 weight;      ///< what a lane's radiance counts in its pixel
  Lanes path_length;  ///< from the path's start to the origin of the lane's ray
  Lanes open;         ///< share of a camera ray that only holes have been in the way of; 0: the ray has left its line
  alignas(64) std::uint32_t pixel[kLanes];
};

/// The rays with which paths can go on behind a packet of surface points: mirrored ones (entry = lane) and transmitted ones
/// (entry = kLanes + lane).
struct Branches {
  static constexpr int kCount = 2 * kLanes;
  alignas(64) float dir_x[kCount], dir_y[kCount], dir_z[kCount];
  alignas(64) float share_x[kCount], share_y[kCount], share_z[kCount];  ///< how much of the radiance from there is sent on
  alignas(64) float open[kCount];                                       ///< how much of Bundle::open stays
};

/// One array per quantity, so that a packet is filled by plain copies.
class RayQueue {
 public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Appends the branches whose entries are in entry[0 ... count - 1], at most Branches::kCount. `packet`, `bundle`: the rays
  /// that hit the surface.
  void append(const SurfacePacket& surface, const RayHitPacket& packet, const Bundle& bundle, const Branches& branches,
              const int* entry, int count);

  /// The rays from `first` on as a packet; hits stay as they are.
  void load(std::size_t first, RayHitPacket& packet, Bundle& bundle, LaneMask& active) const;

 private:
  static constexpr std::size_t kFields = 12;

  float* field(std::size_t index) const { return values_.get() + index * capacity_; }
  void grow();

  std::size_t size_ = 0, capacity_ = 0;
  std::unique_ptr<float[]> values_;  ///< kFields arrays of capacity_: origin, direction, weight, path length, tnear,
                                     ///< open
  std::unique_ptr<std::uint32_t[]> pixel_;
};

}  // namespace lippmann

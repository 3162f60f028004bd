#include "trace/ray_queue.hpp"

namespace lippmann {
namespace {

/// The arrays of the queue from some ray on.
struct QueueView {
  float *org_x, *org_y, *org_z, *dir_x, *dir_y, *dir_z, *weight_x, *weight_y, *weight_z, *path_length, *tnear;
  std::uint32_t* pixel;
};

/// Always a whole packet: what is written behind the last entry is overwritten by the next ones.
LIPPMANN_MULTIVERSION void copy_branches(const SurfacePacket& s, const RayHitPacket& packet, const Bundle& bundle,
                                         const Branches& branches, const int* entry, const QueueView to) {
  LIPPMANN_FOR_LANES(k) {
    const int e = entry[k], lane = e & (kLanes - 1);
    to.org_x[k] = s.position.x[lane], to.org_y[k] = s.position.y[lane], to.org_z[k] = s.position.z[lane];
    to.dir_x[k] = branches.dir_x[e], to.dir_y[k] = branches.dir_y[e], to.dir_z[k] = branches.dir_z[e];
    to.weight_x[k] = bundle.weight.x[lane] * branches.share_x[e];
    to.weight_y[k] = bundle.weight.y[lane] * branches.share_y[e];
    to.weight_z[k] = bundle.weight.z[lane] * branches.share_z[e];
    to.path_length[k] = bundle.path_length[lane] + packet.ray.tfar[lane];
    to.tnear[k] = s.t_near[lane];
    to.pixel[k] = bundle.pixel[lane];
  }
}

template <class Value>
LIPPMANN_INLINE void copy_lanes(const Value* from, Value* to) {
  LIPPMANN_FOR_LANES(i) to[i] = from[i];
}

LIPPMANN_MULTIVERSION void fill_packet(const float* values, std::size_t stride, const std::uint32_t* pixel, int lanes,
                                       RayHitPacket& packet, Bundle& bundle, LaneMask& active) {
  float* const to[] = {packet.ray.org_x,     packet.ray.org_y,        packet.ray.org_z,     packet.ray.dir_x,
                       packet.ray.dir_y,     packet.ray.dir_z,        bundle.weight.x.lane, bundle.weight.y.lane,
                       bundle.weight.z.lane, bundle.path_length.lane, packet.ray.tnear};
  for (std::size_t f = 0; f < std::size(to); ++f) copy_lanes(values + f * stride, to[f]);
  copy_lanes(pixel, bundle.pixel);
  LIPPMANN_FOR_LANES(i) {
    packet.ray.tfar[i] = kInfinity;
    active.lane[i] = i < lanes ? -1 : 0;
  }
}

}  // namespace

void RayQueue::append(const SurfacePacket& surface, const RayHitPacket& packet, const Bundle& bundle, const Branches& branches,
                      const int* entry, int count) {
  if (size_ + Branches::kCount > capacity_) grow();
  for (int first = 0; first < count; first += kLanes) {
    const auto at = [&](std::size_t f) { return field(f) + size_ + first; };
    copy_branches(
        surface, packet, bundle, branches, entry + first,
        {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9), at(10), pixel_.data() + size_ + first});
  }
  size_ += static_cast<std::size_t>(count);
}

void RayQueue::load(std::size_t first, RayHitPacket& packet, Bundle& bundle, LaneMask& active) const {
  const auto lanes = static_cast<int>(std::min<std::size_t>(kLanes, size_ - first));
  fill_packet(field(0) + first, capacity_, pixel_.data() + first, lanes, packet, bundle, active);
}

/// Twice the room, at least that of a batch; always with that of a whole append behind the last ray.
void RayQueue::grow() {
  const std::size_t capacity = std::max<std::size_t>(2 * capacity_, 2048);
  std::vector<float> values(kFields * capacity, 0.0f);
  for (std::size_t f = 0; f < kFields; ++f) std::copy_n(field(f), size_, values.data() + f * capacity);
  values_.swap(values);
  pixel_.resize(capacity);
  capacity_ = capacity;
}

}  // namespace lippmann

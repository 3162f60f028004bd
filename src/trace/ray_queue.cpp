#include "trace/ray_queue.hpp"

#include <fmt/format.h>

#include <cstring>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// Maximum number of rays of one wave, which take about 200 MB.
constexpr std::size_t kMostRays = std::size_t{1} << 22;

struct QueueView {
  float *org_x, *org_y, *org_z, *dir_x, *dir_y, *dir_z, *weight_x, *weight_y, *weight_z, *path_length, *tnear, *open;
  std::uint32_t* pixel;
};

using Register = float __attribute__((vector_size(4 * kLanes)));
using Indices = std::int32_t __attribute__((vector_size(4 * kLanes)));

// picked_of() must be inlined, because builds of a kernel for different CPUs pass vectors of this size in different registers.
#ifdef __clang__  // Clang has no __builtin_shuffle.
LIPPMANN_INLINE Register picked_of(const Register& first, const Register& second, const Indices& index) {
  Register picked;
  for (int k = 0; k < kLanes; ++k) {
    const std::int32_t i = index[k] & (2 * kLanes - 1);
    picked[k] = i < kLanes ? first[i] : second[i - kLanes];
  }
  return picked;
}
LIPPMANN_INLINE Register picked_of(const Register& source, const Indices& index) { return picked_of(source, source, index); }
#else
LIPPMANN_INLINE Register picked_of(const Register& first, const Register& second, const Indices& index) {
  return __builtin_shuffle(first, second, index);
}
LIPPMANN_INLINE Register picked_of(const Register& source, const Indices& index) { return __builtin_shuffle(source, index); }
#endif

/// Sets to[k] = from[index[k]] for 16 words. This code compiles to one AVX-512 instruction, while a loop would become sixteen
/// loads.
LIPPMANN_INLINE void pick(const void* from, const Indices& index, void* to) {
  Register source;
  std::memcpy(&source, from, sizeof(source));
  const Register picked = picked_of(source, index);
  std::memcpy(to, &picked, sizeof(picked));
}

/// Sets to[k] = from[index[k]] for 16 words out of 32.
LIPPMANN_INLINE void pick_of_two(const float* from, const Indices& index, float* to) {
  Register first, second;
  std::memcpy(&first, from, sizeof(first));
  std::memcpy(&second, from + kLanes, sizeof(second));
  const Register picked = picked_of(first, second, index);
  std::memcpy(to, &picked, sizeof(picked));
}

/// Copies sixteen entries, even if fewer are valid. The next append() overwrites the surplus.
LIPPMANN_MULTIVERSION void copy_branches(const SurfacePacket& s, const RayHitPacket& packet, const Bundle& bundle,
                                         const Branches& branches, const int* entry, const QueueView to) {
  Indices of_branch, lane;
  std::memcpy(&of_branch, entry, sizeof(of_branch));
  lane = of_branch & (kLanes - 1);
  pick(s.position.x.lane, lane, to.org_x), pick(s.position.y.lane, lane, to.org_y), pick(s.position.z.lane, lane, to.org_z);
  pick_of_two(branches.dir_x, of_branch, to.dir_x);
  pick_of_two(branches.dir_y, of_branch, to.dir_y);
  pick_of_two(branches.dir_z, of_branch, to.dir_z);
  Lanes3 share, weight;
  pick_of_two(branches.share_x, of_branch, share.x.lane);
  pick_of_two(branches.share_y, of_branch, share.y.lane);
  pick_of_two(branches.share_z, of_branch, share.z.lane);
  pick(bundle.weight.x.lane, lane, weight.x.lane);
  pick(bundle.weight.y.lane, lane, weight.y.lane);
  pick(bundle.weight.z.lane, lane, weight.z.lane);
  Lanes path_length, ray_length, open, open_share;
  pick(bundle.path_length.lane, lane, path_length.lane);
  pick(packet.ray.tfar, lane, ray_length.lane);
  pick(bundle.open.lane, lane, open.lane);
  pick_of_two(branches.open, of_branch, open_share.lane);
  LIPPMANN_FOR_LANES(k) {
    to.weight_x[k] = weight.x[k] * share.x[k];
    to.weight_y[k] = weight.y[k] * share.y[k];
    to.weight_z[k] = weight.z[k] * share.z[k];
    to.path_length[k] = path_length[k] + ray_length[k];
    to.open[k] = open[k] * open_share[k];
  }
  pick(s.t_near.lane, lane, to.tnear);
  pick(bundle.pixel, lane, to.pixel);
}

template <class Value>
LIPPMANN_INLINE void copy_lanes(const Value* from, Value* to) {
  LIPPMANN_FOR_LANES(i) to[i] = from[i];
}

LIPPMANN_MULTIVERSION void fill_packet(const float* values, std::size_t stride, const std::uint32_t* pixel, int lanes,
                                       RayHitPacket& packet, Bundle& bundle, LaneMask& active) {
  float* const to[] = {packet.ray.org_x,     packet.ray.org_y,        packet.ray.org_z,     packet.ray.dir_x,
                       packet.ray.dir_y,     packet.ray.dir_z,        bundle.weight.x.lane, bundle.weight.y.lane,
                       bundle.weight.z.lane, bundle.path_length.lane, packet.ray.tnear,     bundle.open.lane};
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
        {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9), at(10), at(11), pixel_.get() + size_ + first});
  }
  size_ += static_cast<std::size_t>(count);
}

void RayQueue::load(std::size_t first, RayHitPacket& packet, Bundle& bundle, LaneMask& active) const {
  const auto lanes = static_cast<int>(std::min<std::size_t>(kLanes, size_ - first));
  fill_packet(field(0) + first, capacity_, pixel_.get() + first, lanes, packet, bundle, active);
}

/// Doubles the capacity. The memory is not cleared, because entries behind the last ray are read only into inactive lanes.
void RayQueue::grow() {
  const std::size_t capacity = std::max<std::size_t>(2 * capacity_, 2048);
  if (capacity > kMostRays)
    throw Error("scene", fmt::format("transparent mirrors split paths into more than {} rays at once", kMostRays),
                "a smaller `max-depth`: each vertex of a path may double its rays");
  auto values = std::make_unique_for_overwrite<float[]>(kFields * capacity);
  auto pixel = std::make_unique_for_overwrite<std::uint32_t[]>(capacity);
  for (std::size_t f = 0; f < kFields; ++f) std::copy_n(field(f), size_, values.get() + f * capacity);
  std::copy_n(pixel_.get(), size_, pixel.get());
  values_.swap(values);
  pixel_.swap(pixel);
  capacity_ = capacity;
}

}  // namespace lippmann

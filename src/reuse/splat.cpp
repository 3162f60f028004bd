#include "reuse/splat.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>
#include <variant>

#include "reuse/make_landing.hpp"
#include "reuse/move_points.hpp"

namespace lippmann {
namespace {

constexpr int kSplatBlock = 64;
constexpr int kRowsPerStrip = 64;
// If a point lands within this distance of a sample, in units of the sample spacing, the sample's colour is not interpolated.
constexpr float kNearEnough = 0.1f;
constexpr int kLeftBit = 1;
static_assert(kRightDiffers == 1 && kLeftDiffers == 1 << kLeftBit);
constexpr std::uint32_t kBackgroundOrder = SplatBuffer::kBackgroundOrder;
constexpr float kBackgroundBelow = std::numeric_limits<float>::lowest();

struct Block {
  alignas(64) std::int32_t target[kSplatBlock];
  alignas(64) std::uint32_t order[kSplatBlock];   ///< upper half of the points' SplatBuffer keys
  alignas(64) std::uint32_t source[kSplatBlock];  ///< lower half of the points' SplatBuffer keys
};

struct RowOfPoints {
  const float* z;
  const std::uint32_t* object;
  const std::uint8_t* contrast;  ///< null if the contrast is not computed
  int row, first;
};

struct Limits {
  int width;
  float front, back;  ///< points with z (mm) outside this range are dropped
};

/// Maps depths to integers above kBackgroundOrder. Greater depths have greater integers.
LIPPMANN_INLINE std::uint32_t order_of(float depth) {
  const auto bits = std::bit_cast<std::uint32_t>(depth + 0.0f);  // adding 0 turns -0 into +0
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

template <class T>
LIPPMANN_INLINE void load(const T* from, int lanes, T* to) {
  if (lanes == kPointLanes) {
    std::memcpy(to, from, kPointLanes * sizeof(T));
  } else {
    std::memset(to, 0, kPointLanes * sizeof(T));
    std::memcpy(to, from, static_cast<std::size_t>(lanes) * sizeof(T));
  }
}

/// Projects `lanes` points of a row and stores their targets in `block`. The fixed size of the local arrays lets the compiler
/// keep them in registers.
template <class Rule>
LIPPMANN_INLINE void project_lanes(const Rule& rule, const Limits& limits, const Motion& motion, const RowOfPoints& points,
                                   int first, int lanes, Block& block) {
  const auto row = rule.row(points.row, points.first + first);
  alignas(64) float depth[kPointLanes];
  alignas(64) std::uint8_t contrast_bytes[kPointLanes] = {};
  alignas(64) std::uint32_t contrast[kPointLanes], order[kPointLanes], source[kPointLanes];
  alignas(64) std::int32_t target[kPointLanes];
  load(points.z + first, lanes, depth);
  if (points.contrast) load(points.contrast + first, lanes, contrast_bytes);
  for (int i = 0; i < kPointLanes; ++i) contrast[i] = contrast_bytes[i];
  Positions p;
  StillLanes still;
  for (int i = 0; i < kPointLanes; ++i) {
    const Vec3f point = point_by(rule, row, i, depth[i]);
    p.x[i] = point.x, p.y[i] = point.y, p.z[i] = point.z;
  }
  if (motion.uniform()) {
    move_alike(motion.groups[0], p, still);
  } else {
    alignas(64) std::uint32_t object[kPointLanes];
    load(points.object + first, lanes, object);
    move_each(motion, object, p, still);
  }
  const std::int32_t own = points.row * limits.width + points.first + first, width = limits.width;
  const float front = limits.front, back = limits.back;
  for (int i = 0; i < kPointLanes; ++i) {
    // Each selection has a single condition, because the compiler vectorises only such loops.
    const PointLanding at = land_by(rule, row, i, p.x[i], p.y[i], p.z[i]);
    const bool lands = (at.column >= 0.0f) & (at.row >= 0.0f) & (p.z[i] <= front) & (p.z[i] >= back);
    const std::int32_t landed =
        static_cast<std::int32_t>(lands ? at.row : 0.0f) * width + static_cast<std::int32_t>(lands ? at.column : 0.0f);
    const std::int32_t moved = lands ? landed : -1, stays = own + i;
    const std::int32_t moved_or_still = still.lane[i] != 0 ? stays : moved;
    const std::int32_t not_missed = depth[i] == depth[i] ? moved_or_still : -1;
    const bool background = depth[i] < kBackgroundBelow;
    target[i] = background ? stays : not_missed;
    order[i] = background ? kBackgroundOrder : order_of(p.z[i]);
    const std::uint32_t changes = at.off_x > 0.0f ? contrast[i] >> kLeftBit & 1u : contrast[i] & 1u;
    const std::uint32_t worth = std::abs(at.off_x) < kNearEnough ? 0u : changes;
    const std::uint32_t flag = still.lane[i] != 0 ? 0u : worth;
    source[i] = ~(2u * static_cast<std::uint32_t>(stays) + 1u) | flag;
  }
  std::memcpy(block.target + first, target, sizeof(target));
  std::memcpy(block.order + first, order, sizeof(order));
  std::memcpy(block.source + first, source, sizeof(source));
}

/// Calls `use` with the landing rule that `any` holds. std::visit would not compile `use` for the caller's instruction set.
template <class Use, std::size_t... I>
LIPPMANN_INLINE void use_landing(const AnyLanding& any, const Use& use, std::index_sequence<I...>) {
  (void)((any.index() == I && (use(*std::get_if<I>(&any)), true)) || ...);
}

LIPPMANN_MULTIVERSION void project(const AnyLanding& any, const Limits& limits, const Motion& motion, const RowOfPoints& points,
                                   int count, Block& block) {
  const auto project_by = [&](const auto& rule) LIPPMANN_INLINE_LAMBDA {
    for (int first = 0; first < count; first += kPointLanes)
      project_lanes(rule, limits, motion, points, first, std::min(kPointLanes, count - first), block);
  };
  use_landing(any, project_by, std::make_index_sequence<std::variant_size_v<AnyLanding>>());
}

/// A point whose target is in another strip (group of rows) than its source.
struct Stray {
  std::int32_t target;
  std::uint64_t key;
};

struct Strays {
  std::vector<Stray> points;
  std::int32_t lowest = std::numeric_limits<std::int32_t>::max(), highest = -1;

  void add(std::int32_t target, std::uint64_t key) {
    points.push_back({target, key});
    lowest = std::min(lowest, target), highest = std::max(highest, target);
  }
};

struct TargetRange {
  std::int32_t begin, end;
  bool holds(std::int32_t target) const { return target >= begin && target < end; }
};

void offer(std::uint64_t& held, std::uint64_t key) { held = std::max(held, key); }

void offer_block(const Block& block, int count, TargetRange own, std::uint64_t* keys, Strays& strays) {
  for (int i = 0; i < count; ++i) {
    const std::int32_t target = block.target[i];
    const std::uint64_t key = std::uint64_t{block.order[i]} << 32 | block.source[i];
    if (own.holds(target))
      offer(keys[target], key);
    else if (target >= 0)
      strays.add(target, key);
  }
}

void offer_strays(const std::vector<Strays>& strays, TargetRange own, std::uint64_t* keys) {
  for (const Strays& from : strays) {
    if (from.highest < own.begin || from.lowest >= own.end) continue;
    for (const Stray& stray : from.points)
      if (own.holds(stray.target)) offer(keys[stray.target], stray.key);
  }
}

void order_by_source(Block& block, int count) {
  for (int i = 0; i < count; ++i) block.order[i] = (~block.source[i] >> 1) + 1;
}

}  // namespace

struct Splatter::Impl {
  AnyLanding rule;
  Limits limits;
  int height;
  bool z_buffer;

  TargetRange targets_of_strip(std::size_t strip) const {
    const int first = static_cast<int>(strip) * kRowsPerStrip, end = std::min(height, first + kRowsPerStrip);
    return {first * limits.width, end * limits.width};
  }

  void splat_strip(const PointImage& image, const Motion& motion, TargetRange own, std::uint64_t* keys, Strays& strays) const {
    const PrimaryPoints& p = image.points;
    Block block;
    std::fill(keys + own.begin, keys + own.end, 0);
    for (int row_begin = own.begin; row_begin < own.end; row_begin += limits.width)
      for (int i = 0; i < limits.width; i += kSplatBlock) {
        const int count = std::min(kSplatBlock, limits.width - i);
        const auto at = static_cast<std::size_t>(row_begin + i);
        const std::uint8_t* contrast = image.contrast.empty() ? nullptr : &image.contrast[at];
        const RowOfPoints points{&p.z[at], &p.object[at], contrast, row_begin / limits.width, i};
        project(rule, limits, motion, points, count, block);
        if (!z_buffer) order_by_source(block, count);
        offer_block(block, count, own, keys, strays);
      }
  }

  PointLanding land_point(std::uint32_t pixel, float z, std::uint32_t object, const Motion& motion, float& moved_z) const {
    const auto width = static_cast<std::uint32_t>(limits.width);
    const int row = static_cast<int>(pixel / width), column = static_cast<int>(pixel % width);
    return std::visit(
        [&](const auto& landing) {
          const auto r = landing.row(row, column);
          const Vec3f p = moved_point(motion, object, point_by(landing, r, 0, z));
          moved_z = p.z;
          return land_by(landing, r, 0, p.x, p.y, p.z);
        },
        rule);
  }

  void restore_depths(const PointImage& image, const Motion& motion, TargetRange own, std::uint64_t* keys) const {
    for (std::int32_t target = own.begin; target < own.end; ++target) {
      if (keys[target] == 0) continue;
      const std::uint32_t source = SplatBuffer::source(keys[target]);
      float z = 0.0f;
      const std::uint32_t object = image.points.object[source];
      land_point(source, image.points.z[source], object, motion, z);
      const std::uint32_t order = object == kNoObject ? kBackgroundOrder : order_of(z);
      keys[target] = std::uint64_t{order} << 32 | static_cast<std::uint32_t>(keys[target]);
    }
  }
};

Splatter::Splatter(const Optics& optics, const SplatParams& params)
    : impl_(new Impl{make_landing(optics, params.mode),
                     {film_size(optics).x, resolved_z_front_mm(optics), -optics.z_back_mm},
                     film_size(optics).y,
                     params.z_buffer}) {}
Splatter::~Splatter() = default;

void Splatter::splat(const PointImage& image, const Motion& motion, const ThreadPool& pool, SplatBuffer& buffer) const {
  const std::size_t strips = static_cast<std::size_t>((impl_->height + kRowsPerStrip - 1) / kRowsPerStrip);
  buffer.keys.resize(image.points.object.size());
  std::vector<Strays> strays(strips);
  pool.for_each(strips, [&](std::size_t s) {
    impl_->splat_strip(image, motion, impl_->targets_of_strip(s), buffer.keys.data(), strays[s]);
  });
  pool.for_each(strips, [&](std::size_t s) {
    const TargetRange own = impl_->targets_of_strip(s);
    offer_strays(strays, own, buffer.keys.data());
    if (!impl_->z_buffer) impl_->restore_depths(image, motion, own, buffer.keys.data());
  });
}

std::optional<std::uint32_t> Splatter::landing(std::uint32_t pixel, float z, std::uint32_t object, const Motion& motion) const {
  float moved_z = 0.0f;
  const PointLanding at = impl_->land_point(pixel, z, object, motion, moved_z);
  const bool lands = at.column >= 0.0f && at.row >= 0.0f && moved_z <= impl_->limits.front && moved_z >= impl_->limits.back;
  if (!lands) return std::nullopt;
  return static_cast<std::uint32_t>(at.row) * static_cast<std::uint32_t>(impl_->limits.width) +
         static_cast<std::uint32_t>(at.column);
}

}  // namespace lippmann

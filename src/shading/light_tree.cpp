#include "shading/light_tree.hpp"

namespace lippmann {
namespace {

/// A light below the receiver's horizon keeps this fraction of its weight.
constexpr float kLeastFacing = 1.0f / 16.0f;
/// Lower bound of squared distances, as in the evaluation of lamps.
constexpr float kLeastSquared = 1e-20f;
/// Lower bound of the squared cosine of faces seen edge-on, so that rounding does not remove their light.
constexpr float kLeastSquaredCosine = 1e-6f;
constexpr float kLeastFaceShining = 1e-4f;
/// Lower bounds of `shining` (light_tree.hpp) inside the cones. kLeastShining is relative to the mean emission of a cluster,
/// kLeastFading to the full light of a single lamp.
constexpr float kLeastShining = 1.0f / 16.0f, kLeastFading = 1e-3f;
/// Relative enlargement of ranges and cones, so that rounding does not remove light.
constexpr float kMargin = 1e-4f;

/// Pointers to the arrays of a tree, or null for arrays that the tree lacks.
struct LightNodes {
  const LightNode* nodes;
  const LightCones* cones;
  const LightBeams* beams;
  const LightFaces* faces;
};

LIPPMANN_INLINE void weigh_places(const LightNode& n, const LightReceiver& at, Lanes& w) {
  const Vec3f p = at.position, m = at.normal;
  const float least = m == Vec3f(0.0f) ? 1.0f : kLeastFacing, most = 1.0f - least;
  LIPPMANN_FOR_LANES(i) {
    const float dx = n.x[i] - p.x, dy = n.y[i] - p.y, dz = n.z[i] - p.z;
    const float squared = dx * dx + dy * dy + dz * dz, mean = std::max(squared + n.variance[i], kLeastSquared);
    const float above = m.x * dx + m.y * dy + m.z * dz;
    const float height = 0.5f * (above + std::sqrt(above * above + n.variance[i] * (1.0f / 3.0f)));
    const float reach = (n.range[i] + n.radius[i]) * (1.0f + kMargin);
    const float root = std::sqrt(mean), inverse = 1.0f / root, facing = (least * root + most * height) * inverse;
    w[i] = squared <= reach * reach ? n.power[i] * facing * inverse * inverse : 0.0f;
  }
}

/// Multiplies w by the factor `shining` of lamps, which is 0 if the point lies outside the child's cone by more than the
/// child's angular radius.
LIPPMANN_INLINE void weigh_cones(const LightNode& n, const LightCones& c, const LightBeams& b, const LightReceiver& at,
                                 Lanes& w) {
  const Vec3f p = at.position;
  LIPPMANN_FOR_LANES(i) {
    const float dx = p.x - n.x[i], dy = p.y - n.y[i], dz = p.z - n.z[i];
    const float squared = std::max(dx * dx + dy * dy + dz * dz, kLeastSquared);
    const float sine = n.radius[i] / std::sqrt(squared), cosine = std::sqrt(std::max(1.0f - sine * sine, 0.0f));
    const float along = (c.x[i] * dx + c.y[i] * dy + c.z[i] * dz) / std::sqrt(squared);
    const float edge = c.cosine[i] * cosine - c.sine[i] * sine - kMargin;
    const bool all = (sine >= 1.0f) | (cosine <= -c.cosine[i]);
    const float ramp = std::min(std::max((along - c.cosine[i]) * b.inverse_ramp[i], 0.0f), 1.0f);
    const float fading = std::max(ramp * ramp, kLeastFading);
    const float unit = 1.0f / std::sqrt(squared + n.variance[i]), x = dx * unit, y = dy * unit, z = dz * unit;
    const float square =
        b.xx[i] * (x * x - z * z) + b.yy[i] * (y * y - z * z) + 2.0f * (b.xy[i] * x * y + b.xz[i] * x * z + b.yz[i] * y * z);
    const float mean = b.mean[i] + b.linear.x[i] * x + b.linear.y[i] * y + b.linear.z[i] * z + square;
    const float shining = b.inverse_ramp[i] > 0.0f ? fading : std::max(mean, kLeastShining * b.mean[i]);
    w[i] = (all | (along >= edge)) ? w[i] * shining : 0.0f;
  }
}

LIPPMANN_INLINE void weigh_faces(const LightNode& n, const LightFaces& f, const LightReceiver& at, Lanes& w) {
  const Vec3f p = at.position;
  LIPPMANN_FOR_LANES(i) {
    const float dx = n.x[i] - p.x, dy = n.y[i] - p.y, dz = n.z[i] - p.z;
    const float mean = std::max(dx * dx + dy * dy + dz * dz + n.variance[i], kLeastSquared);
    const float along = dx * dx * f.xx[i] + dy * dy * f.yy[i] + dz * dz * f.zz[i] +
                        2.0f * (dx * dy * f.xy[i] + dx * dz * f.xz[i] + dy * dz * f.yz[i]);
    const float even = std::max(along, 0.0f) + (1.0f / 16.0f) * n.variance[i] + kLeastSquaredCosine * mean;
    const float front = f.front.x[i] * dx + f.front.y[i] * dy + f.front.z[i] * dz;
    w[i] *= std::max((std::sqrt(even) - front) / std::sqrt(mean), kLeastFaceShining);
  }
}

/// Prefetches all cache lines of a node that weigh() reads.
LIPPMANN_INLINE void prefetch(const LightNodes& tree, std::uint32_t node) {
  const auto lines_of = [](const auto* part, std::size_t index) {
    if (!part) return;
    const char* const begin = reinterpret_cast<const char*>(part + index);
    for (std::size_t at = 0; at < sizeof *part; at += 64) __builtin_prefetch(begin + at);
  };
  lines_of(tree.nodes, node), lines_of(tree.faces, node), lines_of(tree.cones, node), lines_of(tree.beams, node);
}

LIPPMANN_INLINE void weigh(const LightNodes& tree, std::uint32_t node, const LightReceiver& at, Lanes& w) {
  weigh_places(tree.nodes[node], at, w);
  if (tree.cones) weigh_cones(tree.nodes[node], tree.cones[node], tree.beams[node], at, w);
  if (tree.faces) weigh_faces(tree.nodes[node], tree.faces[node], at, w);
}

/// Partial sums of sixteen weights w. For i < 8, element i is w[i] + w[i + 8]. For i < 4, element 8 + i is the sum of the
/// elements i and i + 4. Elements 12 and 13 are formed in the same way. Element 14 is the total.
struct Sums {
  float of[kLanes];
  LIPPMANN_INLINE float all() const { return of[14]; }
};

LIPPMANN_INLINE void add_up(const Lanes& w, Sums& s) {
  for (int i = 0; i < 8; ++i) s.of[i] = w[i] + w[i + 8];
  for (int i = 0; i < 4; ++i) s.of[8 + i] = s.of[i] + s.of[4 + i];
  for (int i = 0; i < 2; ++i) s.of[12 + i] = s.of[8 + i] + s.of[10 + i];
  s.of[14] = s.of[12] + s.of[13];
}

/// Chooses one of two weights by u in [0, sum), and subtracts from `u` the weights before it. Never chooses a weight of 0.
LIPPMANN_INLINE int pick_second(float first, float second, float& u) {
  if (u < first || !(second > 0.0f)) return 0;
  u = std::max(u - first, 0.0f);
  return 1;
}

/// Chooses a lane in proportion to the weights by u in [0, 1). Sets `u` to a new random number in [0, 1).
LIPPMANN_INLINE int pick(const Lanes& w, const Sums& s, float& u) {
  u *= s.all();
  int lane = pick_second(s.of[12], s.of[13], u);
  lane += 2 * pick_second(s.of[8 + lane], s.of[10 + lane], u);
  lane += 4 * pick_second(s.of[lane], s.of[4 + lane], u);
  lane += 8 * pick_second(w[lane], w[lane + 8], u);
  u = std::min(u / w[lane], 0x1.fffffep-1f);
  return lane;
}

/// Chooses a light by one descent through the tree, and sets `child` to ~(index of the light). Returns the probability of the
/// choice, or 0 if no light reaches the point.
LIPPMANN_MULTIVERSION float descend(const LightNodes& tree, const LightReceiver& at, float& u, std::int32_t& child) {
  float probability = 1.0f;
  child = 0;
  do {
    const auto node = static_cast<std::uint32_t>(child);
    Lanes w;
    weigh(tree, node, at, w);
    Sums sums;
    add_up(w, sums);
    if (!(sums.all() > 0.0f)) return 0.0f;
    const int lane = pick(w, sums, u);
    probability *= w[lane] / sums.all();
    child = tree.nodes[node].child[lane];
    if (child >= 0) prefetch(tree, static_cast<std::uint32_t>(child));
  } while (child >= 0);
  return probability;
}

LIPPMANN_MULTIVERSION float ascend(const LightNodes& tree, const LightReceiver& at, std::uint32_t slot) {
  float probability = 1.0f;
  while (true) {
    const std::uint32_t node = slot / kLanes;
    Lanes w;
    weigh(tree, node, at, w);
    Sums sums;
    add_up(w, sums);
    if (!(sums.all() > 0.0f)) return 0.0f;
    probability *= w[static_cast<int>(slot % kLanes)] / sums.all();
    if (node == 0) return probability;
    slot = tree.nodes[node].parent;
  }
}

LIPPMANN_MULTIVERSION float weigh_all(const LightNodes& tree, const LightReceiver& at) {
  Lanes w;
  weigh(tree, 0, at, w);
  Sums sums;
  add_up(w, sums);
  return sums.all();
}

/// Clips the ray interval [enter, leave] to the slab between two planes across one axis. `inverse` is 1 / the direction's
/// coordinate and must be finite.
LIPPMANN_INLINE void cut_slab(float lower, float upper, float origin, float inverse, float& enter, float& leave) {
  const float a = (lower - origin) * inverse, b = (upper - origin) * inverse;
  enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
}

float finite_inverse(float x) { return 1.0f / (std::abs(x) > 1e-18f ? x : std::copysign(1e-18f, x)); }

LIPPMANN_MULTIVERSION std::uint32_t touched_lanes(const LightNode& n, const LightBoxes& box, Vec3f o, Vec3f d, Vec3f inverse,
                                                  float reach) {
  alignas(64) std::uint32_t bits[kLanes];
  LIPPMANN_FOR_LANES(i) {
    float enter = 0.0f, leave = reach;
    cut_slab(box.lower.x[i], box.upper.x[i], o.x, inverse.x, enter, leave);
    cut_slab(box.lower.y[i], box.upper.y[i], o.y, inverse.y, enter, leave);
    cut_slab(box.lower.z[i], box.upper.z[i], o.z, inverse.z, enter, leave);
    const float cx = n.x[i] - o.x, cy = n.y[i] - o.y, cz = n.z[i] - o.z;
    const float along = cx * d.x + cy * d.y + cz * d.z;
    const float px = cx - along * d.x, py = cy - along * d.y, pz = cz - along * d.z;
    const bool near_line = px * px + py * py + pz * pz <= n.radius[i] * n.radius[i] * (1.0f + kMargin);
    bits[i] = ((n.power[i] > 0.0f) & near_line & (enter <= leave)) ? 1u << i : 0u;
  }
  std::uint32_t all = 0;
  for (const std::uint32_t bit : bits) all |= bit;
  return all;
}

template <class Part>
const Part* or_null(const std::vector<Part>& parts) {
  return parts.empty() ? nullptr : parts.data();
}

}  // namespace

std::optional<LightTree::Choice> LightTree::choose(const LightReceiver& at, float u) const {
  if (empty()) return std::nullopt;
  std::int32_t child = 0;
  const float probability = descend({nodes_.data(), or_null(cones_), or_null(beams_), or_null(faces_)}, at, u, child);
  if (!(probability > 0.0f)) return std::nullopt;
  return Choice{static_cast<std::uint32_t>(~child), probability};
}

float LightTree::probability(std::uint32_t light, const LightReceiver& at) const {
  if (empty() || slots_[light] == kNowhere) return 0.0f;
  return ascend({nodes_.data(), or_null(cones_), or_null(beams_), or_null(faces_)}, at, slots_[light]);
}

float LightTree::importance(const LightReceiver& at) const {
  return empty() ? 0.0f : weigh_all({nodes_.data(), or_null(cones_), or_null(beams_), or_null(faces_)}, at);
}

std::uint32_t LightTree::touched(std::uint32_t node, const Line& line) const {
  const Vec3f d = line.direction;
  const Vec3f inverse(finite_inverse(d.x), finite_inverse(d.y), finite_inverse(d.z));
  return touched_lanes(nodes_[node], boxes_[node], line.origin, d, inverse, line.reach);
}

}  // namespace lippmann

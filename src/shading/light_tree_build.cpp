#include <algorithm>
#include <array>
#include <numeric>

#include "device/scene_geometry.hpp"
#include "shading/light_tree.hpp"

namespace lippmann {
namespace {

using Members = std::span<std::uint32_t>;

constexpr int kBins = 16;
/// If a cut leaves less than 1 / kLeastPart of the lights on one side, the lights are cut at the median instead. This limits
/// the tree's depth.
constexpr std::size_t kLeastPart = 16;

bool takes_part(const TreeLight& light) {
  const float farthest = std::max({std::abs(light.middle.x), std::abs(light.middle.y), std::abs(light.middle.z)});
  return light.power > 0.0f && std::isfinite(light.power) && farthest <= kLargestReach && light.radius <= kLargestReach;
}

/// The total power of a set of lights, and the first and second moment of the power about a point.
struct PowerMoments {
  std::size_t count = 0;
  double power = 0.0, squares = 0.0;
  Vec3d first{0.0};

  void add(const TreeLight& light, Vec3d about) {
    const Vec3d from = Vec3d(light.middle) - about;
    const auto p = static_cast<double>(light.power);
    ++count, power += p, first += p * from, squares += p * (glm::dot(from, from) + static_cast<double>(light.variance));
  }
  void add(const PowerMoments& m) { count += m.count, power += m.power, first += m.first, squares += m.squares; }
  /// Returns the total power times its spatial variance.
  double scatter() const { return power > 0.0 ? std::max(0.0, squares - glm::dot(first, first) / power) : 0.0; }
};

LightProfile profile_of(const TreeLight& light) {
  if (light.profile) return *light.profile;
  if (!(light.half_angle < kPi)) return {};
  constexpr int kSteps = 64;
  const double outer = std::cos(static_cast<double>(light.half_angle)),
               inner = std::cos(static_cast<double>(light.inner_angle));
  const double width = (1.0 - outer) / kSteps, inverse_ramp = 1.0 / std::max(inner - outer, 1e-6);
  LightProfile profile{0.0, 0.0, 0.0};
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = outer + (i + 0.5) * width, ramp = std::min(1.0, (cosine - outer) * inverse_ramp);
    const double shines = ramp * ramp * width;
    profile.mean += 0.5 * shines;
    profile.linear += 1.5 * shines * cosine;
    profile.square += 2.5 * shines * 0.5 * (3.0 * cosine * cosine - 1.0);
  }
  return profile;
}

float angle_between(Vec3f a, Vec3f b) { return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)); }

}  // namespace

class LightTreeBuilder {
 public:
  LightTreeBuilder(LightTree& tree, std::span<const TreeLight> lights) : tree_(tree), lights_(lights) {
    tree_.slots_.assign(lights.size(), LightTree::kNowhere);
    for (std::uint32_t l = 0; l < lights.size(); ++l)
      if (takes_part(lights[l])) members_.push_back(l);
    for (const std::uint32_t l : members_) {
      total_ += static_cast<double>(lights[l].power);
      has_cones_ |= lights[l].half_angle < kPi || lights[l].profile != nullptr;
      has_balls_ |= lights[l].radius > 0.0f;
      has_faces_ |= lights[l].face != Vec3f(0.0f);
    }
    if (has_cones_)
      for (const TreeLight& light : lights) profiles_.push_back(profile_of(light));
  }

  void build() {
    if (!members_.empty()) add_node(members_, 0);
  }

 private:
  std::uint32_t add_node(Members members, std::uint32_t parent) {
    const auto node = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back().parent = parent;
    if (has_cones_) tree_.cones_.emplace_back(), tree_.beams_.emplace_back();
    if (has_balls_) tree_.boxes_.emplace_back();
    if (has_faces_) tree_.faces_.emplace_back();
    const std::vector<Members> parts = cut(members);
    for (int lane = 0; lane < static_cast<int>(parts.size()); ++lane) {
      const Members part = parts[static_cast<std::size_t>(lane)];
      const std::uint32_t slot = kLanes * node + static_cast<std::uint32_t>(lane);
      describe(part, node, lane);
      if (part.size() == 1) tree_.slots_[part[0]] = slot;
      const std::int32_t child =
          part.size() == 1 ? ~static_cast<std::int32_t>(part[0]) : static_cast<std::int32_t>(add_node(part, slot));
      tree_.nodes_[node].child[lane] = child;  // add_node() may have reallocated nodes_, so no reference to the node is kept
    }
    return node;
  }

  /// Splits the lights `members` into at most kLanes parts, each of which fits into a subtree of the least possible depth.
  std::vector<Members> cut(Members members) const {
    std::size_t fits = 1;
    while (fits * kLanes < members.size()) fits *= kLanes;
    std::vector<Members> parts{members};
    while (parts.size() < kLanes) {
      const auto largest =
          std::max_element(parts.begin(), parts.end(), [](Members a, Members b) { return a.size() < b.size(); });
      if (largest->size() <= fits) break;
      const Members whole = *largest;
      const std::size_t first = halve(whole);
      *largest = whole.first(first);
      parts.push_back(whole.subspan(first));
    }
    return parts;
  }

  /// Cuts the lights `members` in two, and reorders them so that one side of the cut comes first. Returns the number of lights
  /// on that side.
  std::size_t halve(Members members) const {
    Bounds3f box;
    for (const std::uint32_t l : members) box.add(lights_[l].middle);
    const Vec3f size = box.size();
    if (!(std::max({size.x, size.y, size.z}) > 0.0f)) return members.size() / 2;
    const Cut cut = best_cut(members, box);
    const auto side = std::partition(members.begin(), members.end(),
                                     [&](std::uint32_t l) { return bin_of(lights_[l].middle, box, cut.axis) < cut.bin; });
    const auto first = static_cast<std::size_t>(side - members.begin());
    return std::min(first, members.size() - first) * kLeastPart < members.size() ? halve_by_count(members, size) : first;
  }

  std::size_t halve_by_count(Members members, Vec3f size) const {
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = members.size() / 2;
    std::nth_element(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(half), members.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const float at = lights_[a].middle[axis], bt = lights_[b].middle[axis];
                       return at < bt || (at == bt && a < b);
                     });
    return half;
  }

  static int bin_of(Vec3f place, const Bounds3f& box, int axis) {
    const float share = (place[axis] - box.lower[axis]) / (box.upper[axis] - box.lower[axis]);
    return std::clamp(static_cast<int>(share * kBins), 0, kBins - 1);
  }

  struct Cut {
    int axis = 0, bin = kBins / 2;
  };
  Cut best_cut(Members members, const Bounds3f& box) const {
    Cut best;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      if (!(box.upper[axis] > box.lower[axis])) continue;
      std::array<PowerMoments, kBins> bins;
      for (const std::uint32_t l : members)
        bins[static_cast<std::size_t>(bin_of(lights_[l].middle, box, axis))].add(lights_[l], Vec3d(box.center()));
      const std::array<double, kBins> after = scatters_from(bins);
      PowerMoments before;
      for (int bin = 1; bin < kBins; ++bin) {
        before.add(bins[static_cast<std::size_t>(bin - 1)]);
        const double scatter = before.scatter() + after[static_cast<std::size_t>(bin)];
        if (scatter < least) least = scatter, best = {axis, bin};
      }
    }
    return best;
  }

  /// Returns for each bin the scatter (power times variance) of the lights in this bin and all following bins.
  static std::array<double, kBins> scatters_from(const std::array<PowerMoments, kBins>& bins) {
    std::array<double, kBins> scatters{};
    PowerMoments sum;
    for (std::size_t bin = kBins; bin-- > 0;) {
      sum.add(bins[bin]);
      scatters[bin] = sum.scatter();
    }
    return scatters;
  }

  void describe(Members part, std::uint32_t node, int lane) {
    const Vec3d about(lights_[part[0]].middle);
    PowerMoments sum;
    for (const std::uint32_t l : part) sum.add(lights_[l], about);
    const Vec3f middle(about + sum.first / sum.power);
    LightNode& n = tree_.nodes_[node];
    n.x[lane] = middle.x, n.y[lane] = middle.y, n.z[lane] = middle.z;
    n.power[lane] = static_cast<float>(sum.power / total_);
    n.variance[lane] = static_cast<float>(sum.scatter() / sum.power);
    for (const std::uint32_t l : part) {
      const TreeLight& light = lights_[l];
      n.radius[lane] = std::max(n.radius[lane], glm::length(light.middle - middle) + light.radius);
      n.range[lane] = std::max(n.range[lane], light.range);
    }
    if (has_cones_) describe_cone(part, tree_.cones_[node], lane), describe_beam(part, sum.power, tree_.beams_[node], lane);
    if (has_balls_) describe_box(part, tree_.boxes_[node], lane);
    if (has_faces_) describe_faces(part, sum.power, tree_.faces_[node], lane);
  }

  void describe_cone(Members part, LightCones& cones, int lane) const {
    Vec3f axis(0.0f);
    for (const std::uint32_t l : part) axis += lights_[l].axis;
    const float length = glm::length(axis);
    float angle = length > 0.0f ? 0.0f : kPi;
    if (length > 0.0f) axis /= length;
    for (const std::uint32_t l : part)
      angle = std::max(angle, lights_[l].half_angle < kPi ? angle_between(axis, lights_[l].axis) + lights_[l].half_angle : kPi);
    const bool is_all = angle >= kPi;
    cones.x[lane] = axis.x, cones.y[lane] = axis.y, cones.z[lane] = axis.z;
    cones.cosine[lane] = is_all ? -1.0f : std::cos(angle), cones.sine[lane] = is_all ? 0.0f : std::sin(angle);
  }

  void describe_beam(Members part, double power, LightBeams& beams, int lane) const {
    double mean = 0.0;
    Vec3d linear(0.0);
    glm::dmat3 square(0.0);
    for (const std::uint32_t l : part) {
      const LightProfile& profile = profiles_[l];
      const Vec3d axis(lights_[l].axis);
      const double share = static_cast<double>(lights_[l].power) / power;
      mean += share * profile.mean;
      linear += share * profile.linear * axis;
      square += share * profile.square * (1.5 * glm::outerProduct(axis, axis) - glm::dmat3(0.5 * glm::dot(axis, axis)));
    }
    const glm::mat3 q(square);
    beams.mean[lane] = static_cast<float>(mean);
    beams.linear.set(lane, Vec3f(linear));
    beams.xx[lane] = q[0][0], beams.yy[lane] = q[1][1];
    beams.xy[lane] = q[0][1], beams.xz[lane] = q[0][2], beams.yz[lane] = q[1][2];
    const TreeLight& first = lights_[part[0]];
    if (part.size() == 1 && first.half_angle < kPi && !first.profile)
      beams.inverse_ramp[lane] = 1.0f / std::max(std::cos(first.inner_angle) - std::cos(first.half_angle), 1e-6f);
  }

  void describe_box(Members part, LightBoxes& boxes, int lane) const {
    Bounds3f box;
    for (const std::uint32_t l : part) {
      // The ray test of spherical lamps in round_lights.cpp rounds differently, so the boxes are slightly enlarged.
      const float radius = lights_[l].radius * 1.0001f;
      box.add(lights_[l].middle - radius), box.add(lights_[l].middle + radius);
    }
    boxes.lower.set(lane, box.lower), boxes.upper.set(lane, box.upper);
  }

  void describe_faces(Members part, double power, LightFaces& faces, int lane) const {
    glm::dmat3 sum(0.0);
    Vec3d front(0.0);
    for (const std::uint32_t l : part) {
      const Vec3d m(lights_[l].face);
      const double inward = lights_[l].is_closed ? static_cast<double>(LightTree::kLeastInward) : 1.0;
      const double even = 0.5 * (1.0 + inward), odd = 0.5 * (1.0 - inward);
      const double share = static_cast<double>(lights_[l].power) / power;
      sum += share * (lights_[l].face == Vec3f(0.0f) ? glm::dmat3(1.0) : even * even * glm::outerProduct(m, m));
      front += share * odd * m;
    }
    const glm::mat3 mean(sum);
    faces.xx[lane] = mean[0][0], faces.yy[lane] = mean[1][1], faces.zz[lane] = mean[2][2];
    faces.xy[lane] = mean[0][1], faces.xz[lane] = mean[0][2], faces.yz[lane] = mean[1][2];
    faces.front.set(lane, Vec3f(front));
  }

  LightTree& tree_;
  std::span<const TreeLight> lights_;
  std::vector<std::uint32_t> members_;
  std::vector<LightProfile> profiles_;  ///< one element per light; empty if all lights emit in all directions
  double total_ = 0.0;
  bool has_cones_ = false, has_balls_ = false, has_faces_ = false;
};

LightTree::LightTree(std::span<const TreeLight> lights) { LightTreeBuilder(*this, lights).build(); }

}  // namespace lippmann

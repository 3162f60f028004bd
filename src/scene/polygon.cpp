// Based on:
// - D. Eberly, "Triangulation by Ear Clipping", 2002. An ear is a convex corner whose triangle contains no reflex corner.
//   Cutting an ear off can only change whether its two neighbours are ears.
// - I. Sutherland et al., "A Characterization of Ten Hidden-Surface Algorithms", 1974 (Newell's normal).
//
// We deviate from Eberly:
// 1. A reflex corner at the same position as a corner of the ear does not prevent cutting, because in polygons with holes two
//    coincident edges connect the hole to the outline.
// 2. If no ear is left, which only happens in self-intersecting polygons, the rest becomes a triangle fan.
#include "scene/polygon.hpp"

#include <algorithm>
#include <numeric>

namespace lippmann {
namespace {

/// Returns a normal whose length is twice the area of the polygon. From the side that the normal points to, the corners are
/// counter-clockwise.
Vec3d newell_normal(std::span<const Vec3f> corners) {
  Vec3d normal(0.0);
  const Vec3d origin(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += glm::cross(Vec3d(corners[i]) - origin, Vec3d(corners[(i + 1) % corners.size()]) - origin);
  return normal;
}

/// Returns the polygon projected along the largest axis of its normal, counter-clockwise, or no points if it has no area.
std::vector<Vec2d> flattened(std::span<const Vec3f> corners) {
  const Vec3d normal = newell_normal(corners), size = glm::abs(normal);
  if (normal == Vec3d(0.0)) return {};
  const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  std::vector<Vec2d> flat;
  flat.reserve(corners.size());
  for (const Vec3f& corner : corners)
    flat.push_back(normal[dropped] > 0.0 ? Vec2d(corner[u], corner[v]) : Vec2d(corner[v], corner[u]));
  return flat;
}

double turn(Vec2d a, Vec2d b, Vec2d c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool all_turn_left(const std::vector<Vec2d>& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0.0) return false;
  return true;
}

class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2d>& points) : points_(points), left_(static_cast<std::uint32_t>(points.size())) {
    next_.resize(left_), previous_.resize(left_), reflex_.resize(left_), ear_.resize(left_);
    for (std::uint32_t i = 0; i < left_; ++i) next_[i] = (i + 1) % left_, previous_[i] = (i + left_ - 1) % left_;
    for (std::uint32_t i = 0; i < left_; ++i) update_reflex(i);
    for (std::uint32_t i = 0; i < left_; ++i) update_ear(i);
  }

  std::vector<Triangle> run() {
    std::uint32_t at = 0;
    while (left_ > 3 && find_ear(at)) {
      cut(at);
      at = next_[at];
    }
    for (; left_ >= 3; --left_) {
      triangles_.push_back({previous_[at], at, next_[at]});
      const std::uint32_t after = next_[at];
      next_[previous_[at]] = after, previous_[after] = previous_[at];
      at = after;
    }
    return std::move(triangles_);
  }

 private:
  bool find_ear(std::uint32_t& at) const {
    for (std::uint32_t step = 0; step < left_; ++step, at = next_[at])
      if (ear_[at]) return true;
    return false;
  }

  void cut(std::uint32_t ear) {
    const std::uint32_t before = previous_[ear], after = next_[ear];
    triangles_.push_back({before, ear, after});
    next_[before] = after, previous_[after] = before;
    --left_;
    update_reflex(before), update_reflex(after);
    update_ear(before), update_ear(after);
  }

  void update_reflex(std::uint32_t i) { reflex_[i] = turn(points_[previous_[i]], points_[i], points_[next_[i]]) < 0.0; }

  void update_ear(std::uint32_t i) {
    const Vec2d a = points_[previous_[i]], b = points_[i], c = points_[next_[i]];
    ear_[i] = turn(a, b, c) >= 0.0;
    for (std::uint32_t j = next_[next_[i]]; ear_[i] && j != previous_[i]; j = next_[j]) {
      const Vec2d p = points_[j];
      if (!reflex_[j] || p == a || p == b || p == c) continue;
      ear_[i] = turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0;
    }
  }

  const std::vector<Vec2d>& points_;
  std::uint32_t left_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<char> reflex_, ear_;
  std::vector<Triangle> triangles_;
};

std::vector<Triangle> fan(std::size_t corners) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

}  // namespace

bool turns_one_way(std::span<const Vec3f> corners) { return corners.size() < 3 || all_turn_left(flattened(corners)); }

std::vector<Triangle> triangulate(std::span<const Vec3f> corners) {
  if (corners.size() < 3) return {};
  const std::vector<Vec2d> flat = flattened(corners);
  if (flat.empty()) return {};
  if (all_turn_left(flat)) return fan(corners.size());
  return EarClipper(flat).run();
}

}  // namespace lippmann

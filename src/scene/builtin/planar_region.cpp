#include "scene/builtin/planar_region.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "scene/builtin/meshes.hpp"

namespace lippmann::builtin {
namespace {

using Index = std::uint32_t;

constexpr Index kNone = ~Index{0};

/// Returns for each boundary point the next one, in the direction that has the region on the left. Returns kNone for points
/// inside the region.
std::vector<Index> next_on_boundary(const PlanarRegion& region) {
  std::map<std::pair<Index, Index>, int> directed;
  for (const auto& t : region.triangles)
    for (std::size_t c = 0; c < 3; ++c) ++directed[{t[c], t[(c + 1) % 3]}];
  std::vector<Index> next(region.points.size(), kNone);
  for (const auto& [edge, count] : directed)
    if (!directed.contains({edge.second, edge.first})) next[edge.first] = edge.second;
  return next;
}

Vec2f outward_normal(Vec2f from, Vec2f to) {
  const Vec2f along = glm::normalize(to - from);
  return {along.y, -along.x};
}

std::vector<Vec2f> inset(const PlanarRegion& region, const std::vector<Index>& next, float distance) {
  std::vector<Vec2f> inwards(region.points.size(), Vec2f(0.0f));
  for (Index i = 0; i < next.size(); ++i) {
    if (next[i] == kNone) continue;
    const Vec2f normal = outward_normal(region.points[i], region.points[next[i]]);
    inwards[i] -= normal;
    inwards[next[i]] -= normal;
  }
  std::vector<Vec2f> points = region.points;
  for (Index i = 0; i < next.size(); ++i) {
    if (next[i] == kNone) continue;
    // A mitre moves a corner by distance / cos(a), where a is half the angle between the normals n1 and n2 of the two edges
    // that meet there, and |n1 + n2| = 2 cos(a). The factor 1 / cos(a) is limited to 2.
    const float cosine = 0.5f * glm::length(inwards[i]);
    points[i] += distance / std::max(cosine, 0.5f) * glm::normalize(inwards[i]);
  }
  return points;
}

}  // namespace

void fill_between(PlanarRegion& region, const AngularRing& inner, const AngularRing& outer) {
  const float turn = 2.0f * kPi;
  const std::size_t inner_count = inner.points.size(), outer_count = outer.points.size();
  const auto unrolled = [&](const AngularRing& ring, std::size_t i) {
    return ring.angles[i % ring.angles.size()] + (i < ring.angles.size() ? 0.0f : turn);
  };
  std::size_t first = 0;
  const auto gap = [&](std::size_t i) { return std::abs(std::remainder(outer.angles[i] - inner.angles[0], turn)); };
  for (std::size_t i = 1; i < outer_count; ++i)
    if (gap(i) < gap(first)) first = i;
  const float shift = turn * std::round((inner.angles[0] - outer.angles[first]) / turn);

  std::size_t i = 0, o = first;
  while (i < inner_count || o < first + outer_count) {
    const bool outer_next =
        i == inner_count || (o < first + outer_count && unrolled(outer, o + 1) + shift <= unrolled(inner, i + 1));
    const Index a = inner.points[i % inner_count], b = outer.points[o % outer_count];
    const Index c = outer_next ? outer.points[++o % outer_count] : inner.points[++i % inner_count];
    region.triangles.push_back({a, b, c});
  }
}

Mesh extrude(const PlanarRegion& region, float thickness, float bevel) {
  const std::vector<Index> next = next_on_boundary(region);
  const std::vector<Vec2f> face = inset(region, next, bevel);
  const Index count = static_cast<Index>(region.points.size());
  const float half = 0.5f * thickness;

  Mesh mesh;
  for (const Vec2f& p : face) mesh.positions.push_back({p, -half});
  for (const Vec2f& p : region.points) mesh.positions.push_back({p, -half + bevel});
  for (const Vec2f& p : region.points) mesh.positions.push_back({p, half - bevel});
  for (const Vec2f& p : face) mesh.positions.push_back({p, half});
  for (const auto& t : region.triangles) {
    mesh.triangles.push_back({t[2], t[1], t[0]});
    mesh.triangles.push_back({3 * count + t[0], 3 * count + t[1], 3 * count + t[2]});
  }
  for (Index a = 0; a < count; ++a) {
    const Index b = next[a];
    if (b == kNone) continue;
    for (Index layer = 0; layer < 3 * count; layer += count) {
      mesh.triangles.push_back({a + layer, b + layer, b + layer + count});
      mesh.triangles.push_back({a + layer, b + layer + count, a + layer + count});
    }
  }
  return with_creases(mesh, radians(32.0f));
}

}  // namespace lippmann::builtin

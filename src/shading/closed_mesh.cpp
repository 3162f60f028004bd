#include "shading/closed_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {
namespace {

/// Vertices are merged if they are closer than the mesh's size divided by kParts.
constexpr double kParts = 1e6;
/// Meshes with a volume below kLeastVolume times the cube of their size are two-sided sheets.
constexpr double kLeastVolume = 1e-9;

struct Extent {
  Vec3d lower, upper;
  double size() const { return std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z}); }
};

Extent extent_of(const Mesh& mesh) {
  Extent extent{Vec3d(mesh.positions.front()), Vec3d(mesh.positions.front())};
  for (const Vec3f& p : mesh.positions)
    extent.lower = glm::min(extent.lower, Vec3d(p)), extent.upper = glm::max(extent.upper, Vec3d(p));
  return extent;
}

std::vector<std::uint32_t> places_of(const Mesh& mesh, const Extent& extent) {
  using Key = std::array<std::int64_t, 3>;
  const double per_unit = kParts / extent.size();
  std::vector<std::pair<Key, std::uint32_t>> keys(mesh.positions.size());
  for (std::uint32_t v = 0; v < keys.size(); ++v) {
    const Vec3d at = glm::round((Vec3d(mesh.positions[v]) - extent.lower) * per_unit);
    keys[v] = {{static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y), static_cast<std::int64_t>(at.z)}, v};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> places(keys.size());
  std::uint32_t place = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (k > 0 && keys[k].first != keys[k - 1].first) ++place;
    places[keys[k].second] = place;
  }
  return places;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The directed edges of all triangles. `up` holds edges from the lower to the higher position index, `down` edges from
/// the higher to the lower index. In both lists, the first index of an edge is the lower one.
struct Edges {
  std::vector<Edge> up, down;

  void add(std::uint32_t from, std::uint32_t to) { from < to ? up.emplace_back(from, to) : down.emplace_back(to, from); }
  bool all_are_shared_by_two() {
    std::sort(up.begin(), up.end()), std::sort(down.begin(), down.end());
    return up == down && std::adjacent_find(up.begin(), up.end()) == up.end();
  }
};

bool is_closed(const Mesh& mesh, const Extent& extent) {
  const std::vector<std::uint32_t> places = places_of(mesh, extent);
  Edges edges;
  for (const auto& triangle : mesh.triangles) {
    const std::uint32_t a = places[triangle[0]], b = places[triangle[1]], c = places[triangle[2]];
    if (a == b || b == c || c == a) continue;
    edges.add(a, b), edges.add(b, c), edges.add(c, a);
  }
  return !edges.up.empty() && edges.all_are_shared_by_two();
}

double volume_of(const Mesh& mesh, const Extent& extent) {
  double six_times = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto from = [&](std::uint32_t v) { return Vec3d(mesh.positions[v]) - extent.lower; };
    six_times += glm::dot(from(a), glm::cross(from(b), from(c)));
  }
  return six_times / 6.0;
}

}  // namespace

BodyFacing facing_of_closed(const Mesh& mesh) {
  if (mesh.triangles.size() < 4 || mesh.positions.empty()) return BodyFacing::kNone;
  const Extent extent = extent_of(mesh);
  const double size = extent.size();
  if (!(size > 0.0) || !std::isfinite(size) || !is_closed(mesh, extent)) return BodyFacing::kNone;
  const double volume = volume_of(mesh, extent);
  if (!(std::abs(volume) > kLeastVolume * size * size * size)) return BodyFacing::kNone;
  return volume > 0.0 ? BodyFacing::kOutward : BodyFacing::kInward;
}

}  // namespace lippmann

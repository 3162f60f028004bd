// Coloured points become unlit splats because their colours include the lighting. The splats are round Gaussians whose full
// width at half maximum is the diameter of the point. Points without colours become spheres, whose shading shows the shape of
// the cloud.
#include "scene/ply/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "lippmann/core/error.hpp"
#include "scene/ply/columns.hpp"
#include "scene/ply/row.hpp"
#include "scene/ply/vertices.hpp"
#include "scene/splats.hpp"

namespace lippmann::ply {
namespace {

constexpr float kFullWidth = 2.3548200f;

/// Diameters k of spheres and splats, relative to the median distance from a point to its third nearest neighbour.
///
/// If points are scattered at random on a surface, this distance is about 1 / sqrt(density). Spheres then leave a fraction
/// exp(-pi k^2 / 4) of the surface uncovered, which is 4 % for k = 2. Splats show no hole for k >= 1.6.
constexpr float kSphereOverlap = 2.0f, kSplatOverlap = 1.6f;

Splats read_rows(const std::string& name, const Element& element, Body& body, const Vec3d& origin, const Context& context) {
  Columns columns(element);
  const auto xyz = columns.values<3>({{"x", "y", "z"}});
  const auto rgb = columns.color();
  const int alpha = columns.alpha();
  columns.values<3>({{"nx", "ny", "nz"}});
  columns.warn_about_unread(name, context);
  Row row(element);
  Splats points;
  for (std::int64_t i = 0; i < element.count; ++i) {
    body.set_place(element.name, i);
    row.read(body);
    const Vec3d center(row.exact((*xyz)[0]), row.exact((*xyz)[1]), row.exact((*xyz)[2]));
    points.centers.emplace_back(center - origin);
    points.rotations.emplace_back(1.0f, 0.0f, 0.0f, 0.0f);
    points.deviations.emplace_back(1.0f);
    points.opacities.push_back(alpha < 0 ? 1.0f : static_cast<float>(row.share(alpha)));
    Vec3f color(0.0f);
    for (int c = 0; rgb && c < 3; ++c) color[c] = static_cast<float>(row.share((*rgb)[static_cast<std::size_t>(c)]));
    points.harmonics.push_back(first_harmonic_of(color));
  }
  row.warn_about_clamped_colors(name, context);
  return points;
}

/// Returns the distance from point i to its third nearest neighbour among the 32 points before and after i in `centers`. Points
/// at the same position as i are ignored. Returns 0 if no other point is left.
float third_distance(const std::vector<Vec3f>& centers, std::size_t i) {
  constexpr std::size_t kBeside = 32;
  const std::size_t begin = i - std::min(i, kBeside), end = std::min(centers.size(), i + kBeside + 1);
  std::vector<float> distances;
  for (std::size_t k = begin; k < end; ++k)
    if (const float distance = glm::distance(centers[i], centers[k]); distance > 0.0f) distances.push_back(distance);
  if (distances.empty()) return 0.0f;
  const auto third = distances.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(distances.size(), 3) - 1);
  std::nth_element(distances.begin(), third, distances.end());
  return *third;
}

/// Returns the median distance to the third nearest neighbour, from a sample of the points. `centers` must be sorted by
/// sort_by_place().
float spacing(const std::vector<Vec3f>& centers) {
  constexpr std::size_t kMostSampled = 1 << 14;
  std::vector<float> distances;
  for (std::size_t i = 0; i < centers.size(); i += centers.size() / kMostSampled + 1)
    if (const float distance = third_distance(centers, i); distance > 0.0f) distances.push_back(distance);
  if (distances.empty()) return 0.0f;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

float diameter(const std::vector<Vec3f>& centers, double wanted, float overlap) {
  if (wanted > 0.0) return static_cast<float>(wanted);
  const float step = spacing(centers);
  return step > 0.0f ? overlap * step : 1.0f;
}

Spheres spheres_of(const Splats& points, float size) {
  Spheres spheres;
  for (const Vec3f& center : points.centers) spheres.push_back({center, 0.5f * size});
  return spheres;
}

Material point_surface() {
  MetallicRoughness surface;
  surface.base_color = Vec4f(Vec3f(0.8f), 1.0f);
  surface.metallic = 0.0f;
  return {"points", surface};
}

bool has_rows(const Element& element) { return element.count > 0 && (element.name == "face" || element.name == "tristrips"); }

}  // namespace

bool has_points(const Header& header) {
  const Element* vertices = vertices_of(header);
  return vertices && vertices->count > 0 && Columns(*vertices).values<3>({{"x", "y", "z"}}) &&
         std::none_of(header.elements.begin(), header.elements.end(), has_rows);
}

bool has_point_colors(const Header& header) {
  const Element* vertices = vertices_of(header);
  return has_points(header) && Columns(*vertices).color();
}

Scene read_points(const std::string& name, const Header& header, Body& body, double size, const Vec3d& origin,
                  const Context& context) {
  skip_others(name, header, body, context);
  const Vec3d in_file = header.is_z_up ? Vec3d(origin.x, -origin.z, origin.y) : origin;
  Splats points = read_rows(name, *vertices_of(header), body, in_file, context);
  if (const std::size_t dropped = drop_unsound(points); dropped > 0)
    context.warning(fmt::format("{}: {} points are left out: they have values that are not finite.", name, dropped));
  if (points.centers.empty()) throw Error(name, "has no points to show");
  sort_by_place(points);
  const bool is_colored = has_point_colors(header);
  const float across = diameter(points.centers, size, is_colored ? kSplatOverlap : kSphereOverlap);
  Scene scene;
  scene.origin = origin;
  Node node;
  node.name = "points";
  if (header.is_z_up) node.local.rotation = z_to_y();
  scene.nodes.push_back(std::move(node));
  if (is_colored) {
    std::fill(points.deviations.begin(), points.deviations.end(), Vec3f(across / kFullWidth));
    scene.kind = SceneKind::kSplats;
    scene.materials.push_back(splat_material());
    scene.shapes.emplace_back(std::move(points));
  } else {
    scene.materials.push_back(point_surface());
    scene.shapes.emplace_back(spheres_of(points, across));
  }
  scene.instances.push_back({"points", 0, 0, 0});
  return scene;
}

}  // namespace lippmann::ply

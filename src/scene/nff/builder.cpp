// Based on: E. Haines, "Neutral File Format", version 3.9, 1996. The radiance of a surface is the sum of:
// - Kd times the diffuse light, and Ks times Phong's highlight (R.V)^shine, both in the surface's colour,
// - Ks times the mirrored ray,
// - T times the transmitted ray.
//
// We deviate: the highlight is (N.H)^(4 shine). The angle between N and H is half the angle between R and V, so that four times
// the exponent gives the same shape near the highlight's centre.
#include "scene/nff/builder.hpp"

#include <fmt/format.h>

#include "scene/directions.hpp"
#include "scene/nff/cone.hpp"
#include "scene/polygon.hpp"
#include "scene/wind_by_normals.hpp"

namespace lippmann::nff {
namespace {

PhongSurface surface_of(const Fill& fill) {
  PhongSurface surface;
  surface.color = fill.color;
  surface.ambient = 0.0f;
  surface.diffuse = fill.diffuse;
  if (fill.specular > 0.0f) surface.highlight_kind = Highlight::kPlastic;
  surface.highlight = fill.specular;
  surface.highlight_size = 4.0f * fill.shine;
  surface.mirror = fill.specular;
  surface.opacity = 1.0f - fill.transmittance;
  surface.ior = fill.transmittance > 0.0f ? fill.ior : 1.0f;
  return surface;
}

template <class S>
void add_instance(Scene& scene, int material, S& shape, bool empty, std::string_view kind) {
  if (empty) return;
  Instance instance;
  instance.name = fmt::format("{} {}", kind, material);
  instance.shape = static_cast<int>(scene.shapes.size());
  instance.material = material;
  scene.shapes.emplace_back(std::move(shape));
  scene.instances.push_back(std::move(instance));
}

bool has_area(Vec3f a, Vec3f b, Vec3f c) {
  return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)) != glm::dvec3(0.0);
}

Vec3f facet_normal(std::span<const Vec3f> corners, const Triangle& triangle) {
  const glm::dvec3 a(corners[triangle[0]]), b(corners[triangle[1]]), c(corners[triangle[2]]);
  return Vec3f(glm::normalize(glm::cross(b - a, c - a)));
}

}  // namespace

void Builder::set_fill(const Fill& f) {
  const std::array<float, 8> key = {f.color.x, f.color.y, f.color.z, f.diffuse, f.specular, f.shine, f.transmittance, f.ior};
  const auto [entry, is_new] = known_.try_emplace(key, fills_.size());
  current_ = entry->second;
  if (!is_new) return;
  fills_.push_back(f);
  groups_.emplace_back();
}

Builder::Group& Builder::group() {
  if (groups_.empty()) set_fill({});
  return groups_[current_];
}

void Builder::add_sphere(Vec3f center, float radius) {
  if (radius == 0.0f) return void(++left_out_);
  group().spheres.push_back({center, radius});
}

void Builder::add_cone(Vec3f base, float base_radius, Vec3f apex, float apex_radius) {
  if (base == apex || (base_radius == 0.0f && apex_radius == 0.0f)) return void(++left_out_);
  if (base_radius == apex_radius) {
    group().cylinders.push_back({base, apex, base_radius});
    return;
  }
  nff::add_cone(group().smooth, base, base_radius, apex, apex_radius);
  ++cones_;
}

void Builder::add_polygon(std::span<const Vec3f> corners, std::span<const Vec3f> normals) {
  std::vector<Triangle> triangles = triangulate(corners);
  std::erase_if(triangles, [&](const Triangle& t) { return !has_area(corners[t[0]], corners[t[1]], corners[t[2]]); });
  if (triangles.empty()) return void(++left_out_);
  Mesh& mesh = normals.empty() ? group().facets : group().smooth;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  for (const Vec3f& normal : normals)
    mesh.normals.push_back(normal == Vec3f(0.0f) ? facet_normal(corners, triangles.front()) : direction_of(normal));
  for (const Triangle& t : triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

void Builder::finish(Scene& scene) {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    Group& g = groups_[i];
    wind_by_normals(g.smooth);
    const int material = static_cast<int>(scene.materials.size());
    scene.materials.push_back({fmt::format("fill {}", i), surface_of(fills_[i])});
    add_instance(scene, material, g.facets, g.facets.triangles.empty(), "polygons");
    add_instance(scene, material, g.smooth, g.smooth.triangles.empty(), "patches and cones");
    add_instance(scene, material, g.spheres, g.spheres.empty(), "spheres");
    add_instance(scene, material, g.cylinders, g.cylinders.empty(), "cylinders");
  }
}

}  // namespace lippmann::nff

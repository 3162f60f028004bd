#include "scene/tachyon/scene_builder.hpp"

#include <fmt/format.h>

#include <utility>

#include "scene/directions.hpp"
#include "scene/tachyon/handedness.hpp"

namespace lippmann::tachyon {
namespace {

std::uint32_t next_index(const Mesh& mesh) { return static_cast<std::uint32_t>(mesh.positions.size()); }

/// Mirroring reverses the winding, so two corners are swapped.
std::array<std::uint32_t, 3> mirrored_triangle(std::uint32_t i0, std::uint32_t i1, std::uint32_t i2) { return {i0, i2, i1}; }

}  // namespace

SceneBuilder::MaterialKey SceneBuilder::key_of(const PhongSurface& s) {
  const ImageProjection none{};
  const ImageProjection& p = s.projection ? *s.projection : none;
  return {s.color.x,
          s.color.y,
          s.color.z,
          static_cast<float>(s.texture),
          s.ambient,
          s.diffuse,
          s.highlight,
          s.mirror,
          s.opacity,
          static_cast<float>(s.highlight_kind),
          s.projection ? 1.0f : 0.0f,
          static_cast<float>(p.kind),
          s.highlight_size,
          p.center.x,
          p.center.y,
          p.center.z,
          p.rotate.x,
          p.rotate.y,
          p.rotate.z,
          p.scale.x,
          p.scale.y,
          p.scale.z,
          p.u_axis.x,
          p.u_axis.y,
          p.u_axis.z,
          p.v_axis.x,
          p.v_axis.y,
          p.v_axis.z};
}

int SceneBuilder::add_material(const PhongSurface& surface, std::string name) {
  const auto [entry, is_new] = materials_.try_emplace(key_of(surface), static_cast<int>(scene_.materials.size()));
  if (!is_new) return entry->second;
  Material material{std::move(name), surface};
  if (surface.projection) {
    ImageProjection& projection = *std::get<PhongSurface>(material.surface).projection;
    projection.center = mirrored(projection.center);
    projection.u_axis = mirrored(projection.u_axis);
    projection.v_axis = mirrored(projection.v_axis);
  }
  scene_.materials.push_back(std::move(material));
  groups_.emplace_back();
  return entry->second;
}

int SceneBuilder::whitened(int material) {
  const Material& colored = scene_.materials[static_cast<std::size_t>(material)];
  PhongSurface surface = std::get<PhongSurface>(colored.surface);
  surface.color = Vec3f(1.0f);
  surface.texture = -1;
  surface.projection.reset();
  return add_material(surface, colored.name);
}

int SceneBuilder::add_texture(Texture texture) {
  scene_.textures.push_back(std::move(texture));
  return static_cast<int>(scene_.textures.size()) - 1;
}

void SceneBuilder::add_sphere(int material, Vec3f center, float radius) {
  if (radius == 0.0f) return void(++left_out_);
  group(material).spheres.push_back({mirrored(center), radius});
}

void SceneBuilder::add_cylinder(int material, Vec3f base, Vec3f apex, float radius) {
  if (radius == 0.0f || base == apex) return void(++left_out_);
  group(material).cylinders.push_back({mirrored(base), mirrored(apex), radius});
}

void SceneBuilder::add_plane(int material, Vec3f point, Vec3f normal) {
  group(material).planes.push_back({mirrored(point), mirrored(direction_of(normal))});
}

void SceneBuilder::add_ring(int material, Vec3f center, Vec3f normal, float inner, float outer) {
  if (inner >= outer) return void(++left_out_);
  group(material).rings.push_back({mirrored(center), mirrored(direction_of(normal)), inner, outer});
}

void SceneBuilder::add_box(int material, Vec3f corner, Vec3f opposite_corner) {
  const Vec3f a = mirrored(corner), b = mirrored(opposite_corner);
  group(material).boxes.push_back({glm::min(a, b), glm::max(a, b)});
}

bool SceneBuilder::has_area(Vec3f a, Vec3f b, Vec3f c) {
  const Vec3d normal = glm::cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a));
  if (normal != Vec3d(0.0)) return true;
  ++left_out_;
  return false;
}

void SceneBuilder::add_triangle(int material, const std::array<Vec3f, 3>& corners) {
  if (!has_area(corners[0], corners[1], corners[2])) return;
  Mesh& mesh = group(material).facets;
  const std::uint32_t first = next_index(mesh);
  for (const Vec3f corner : corners) mesh.positions.push_back(mirrored(corner));
  mesh.triangles.push_back(mirrored_triangle(first, first + 1, first + 2));
}

void SceneBuilder::add_corners(Mesh& mesh, const std::array<Vertex, 3>& corners, bool colored) {
  if (!has_area(corners[0].position, corners[1].position, corners[2].position)) return;
  const Vec3d facet = glm::cross(Vec3d(corners[1].position) - Vec3d(corners[0].position),
                                 Vec3d(corners[2].position) - Vec3d(corners[0].position));
  const std::uint32_t first = next_index(mesh);
  for (const Vertex& corner : corners) {
    const bool given = corner.normal != Vec3f(0.0f);
    mesh.positions.push_back(mirrored(corner.position));
    mesh.normals.push_back(mirrored(given ? direction_of(corner.normal) : Vec3f(glm::normalize(facet))));
    if (colored) mesh.colors.push_back(corner.color);
  }
  mesh.triangles.push_back(mirrored_triangle(first, first + 1, first + 2));
}

SceneBuilder::IndexedTriangles::IndexedTriangles(SceneBuilder& builder, const std::vector<Vertex>& vertices)
    : builder_(builder), vertices_(vertices), placed_(vertices.size(), -1) {}

void SceneBuilder::IndexedTriangles::set_material(int material, bool colored) {
  for (const int index : used_) placed_[static_cast<std::size_t>(index)] = -1;
  used_.clear();
  material_ = material;
  colored_ = colored;
}

bool SceneBuilder::IndexedTriangles::add(int i0, int i1, int i2) {
  std::array<Vertex, 3> corners;
  const std::array<int, 3> indices{i0, i1, i2};
  bool all_have_normals = true;
  for (std::size_t k = 0; k < 3; ++k) {
    if (indices[k] < 0 || static_cast<std::size_t>(indices[k]) >= vertices_.size()) return false;
    corners[k] = vertices_[static_cast<std::size_t>(indices[k])];
    all_have_normals = all_have_normals && corners[k].normal != Vec3f(0.0f);
  }
  Mesh& mesh = colored_ ? builder_.group(material_).colored : builder_.group(material_).smooth;
  if (!all_have_normals) {  // a corner without a normal gets the triangle's normal, so its vertex cannot be shared
    builder_.add_corners(mesh, corners, colored_);
    return true;
  }
  if (!builder_.has_area(corners[0].position, corners[1].position, corners[2].position)) return true;
  std::array<std::uint32_t, 3> own;
  for (std::size_t k = 0; k < 3; ++k) {
    std::int64_t& place = placed_[static_cast<std::size_t>(indices[k])];
    if (place < 0) {
      place = next_index(mesh);
      used_.push_back(indices[k]);
      mesh.positions.push_back(mirrored(corners[k].position));
      mesh.normals.push_back(mirrored(direction_of(corners[k].normal)));
      if (colored_) mesh.colors.push_back(corners[k].color);
    }
    own[k] = static_cast<std::uint32_t>(place);
  }
  mesh.triangles.push_back(mirrored_triangle(own[0], own[1], own[2]));
  return true;
}

void SceneBuilder::add_light(Light light, Vec3f position, Vec3f direction) {
  Node node;
  node.name = light.name = fmt::format("light {}", scene_.lights.size());
  if (light.kind != LightKind::kDirectional) node.local.translation = mirrored(position);
  if (light.kind != LightKind::kPoint) {
    const Vec3f forward = mirrored(direction_of(direction));
    const bool steep = std::abs(forward.y) > 0.9f;
    node.local.rotation = looking_along(forward, steep ? Vec3f(1.0f, 0.0f, 0.0f) : Vec3f(0.0f, 1.0f, 0.0f));
  }
  light.node = static_cast<int>(scene_.nodes.size());
  scene_.nodes.push_back(std::move(node));
  scene_.lights.push_back(std::move(light));
}

template <class S>
void SceneBuilder::take_shape(int material, S& shape, bool empty, std::string_view kind) {
  if (empty) return;
  const std::string& name = scene_.materials[static_cast<std::size_t>(material)].name;
  scene_.instances.push_back({fmt::format("{} {}", name, kind), static_cast<int>(scene_.shapes.size()), material, -1});
  scene_.shapes.emplace_back(std::move(shape));
}

Scene SceneBuilder::take() {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    Group& g = groups_[i];
    const int material = static_cast<int>(i);
    take_shape(material, g.facets, g.facets.triangles.empty(), "triangles");
    take_shape(material, g.smooth, g.smooth.triangles.empty(), "smooth triangles");
    take_shape(material, g.colored, g.colored.triangles.empty(), "colored triangles");
    take_shape(material, g.spheres, g.spheres.empty(), "spheres");
    take_shape(material, g.cylinders, g.cylinders.empty(), "cylinders");
    take_shape(material, g.planes, g.planes.empty(), "planes");
    take_shape(material, g.rings, g.rings.empty(), "rings");
    take_shape(material, g.boxes, g.boxes.empty(), "boxes");
  }
  groups_.clear();
  materials_.clear();
  return std::exchange(scene_, Scene{});
}

}  // namespace lippmann::tachyon

// SampleRandom::turn() follows K. Shoemake, "Uniform random rotations", Graphics Gems III, 1992.
#include "dataset/dataset_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lippmann {
namespace {

constexpr float kPlaneHeight = 10.0f, kViewHeightMm = 64.0f;

int add_texture(Scene& scene, SampleRandom& random) {
  constexpr int kTexelsPerCell = 4;
  const int cells = 4 + random.below(20), side = kTexelsPerCell * cells;
  Texture texture{.name = {}, .width = side, .height = side, .rgba = {}};
  std::vector<Vec3f> colors(static_cast<std::size_t>(cells) * cells);
  for (Vec3f& color : colors) color = random.color(0.05f, 1.0f);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Vec3f& color = colors[static_cast<std::size_t>(y / kTexelsPerCell) * cells + x / kTexelsPerCell];
      for (int c = 0; c < 3; ++c) texture.rgba.push_back(static_cast<std::uint8_t>(255.0f * color[c]));
      texture.rgba.push_back(255);
    }
  scene.textures.push_back(std::move(texture));
  return static_cast<int>(scene.textures.size()) - 1;
}

int add_material(Scene& scene, bool can_be_textured, SampleRandom& random) {
  MetallicRoughness surface;
  surface.base_color = Vec4f(random.color(0.2f, 1.0f), 1.0f);
  surface.metallic = random.between(0.0f, 1.0f) < 0.2f ? 1.0f : 0.0f;
  surface.roughness = random.between(0.2f, 1.0f);
  surface.double_sided = true;
  if (can_be_textured && random.between(0.0f, 1.0f) < 0.7f) surface.base_color_map.texture = add_texture(scene, random);
  scene.materials.push_back({"", surface});
  return static_cast<int>(scene.materials.size()) - 1;
}

void add_instance(Scene& scene, std::string name, Shape shape, int node, SampleRandom& random) {
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  const int material = add_material(scene, mesh && !mesh->uvs.empty(), random);
  scene.shapes.push_back(std::move(shape));
  scene.instances.push_back(
      {.name = std::move(name), .shape = static_cast<int>(scene.shapes.size()) - 1, .material = material, .node = node});
}

int add_node(Scene& scene, const Transform& local, int parent) {
  scene.nodes.push_back({.name = {}, .parent = parent, .local = local, .matrix = {}});
  return static_cast<int>(scene.nodes.size()) - 1;
}

Shape wall(float z) {
  constexpr float kHalf = 60.0f;
  return Mesh{.positions = {{-kHalf, -kHalf, z}, {kHalf, -kHalf, z}, {kHalf, kHalf, z}, {-kHalf, kHalf, z}},
              .normals = {},
              .uvs = {{0, 4}, {4, 4}, {4, 0}, {0, 0}},
              .triangles = {{0, 1, 2}, {0, 2, 3}}};
}

Shape object_shape(const std::vector<Mesh>& meshes, SampleRandom& random) {
  if (!meshes.empty() && random.between(0.0f, 1.0f) < 0.7f)
    return meshes[static_cast<std::size_t>(random.below(static_cast<int>(meshes.size())))];
  if (random.below(2) == 0) return Spheres{Sphere{}};
  return Boxes{{.lower = Vec3f(-0.6f), .upper = Vec3f(0.6f)}};
}

void animate(Scene& scene, int node, SampleRandom& random) {
  const Transform& local = scene.nodes[static_cast<std::size_t>(node)].local;
  const std::vector<double> times{0.0, scene.timeline.time(1)};
  const Vec3f step(random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f), random.between(-0.3f, 0.3f));
  const Quatf turned = glm::angleAxis(random.between(-0.2f, 0.2f), glm::normalize(random.color(-1.0f, 1.0f) + 1e-3f));
  NodeAnimation animation{
      .node = node, .translation = {times, {local.translation, local.translation + step}}, .rotation = {}, .scale = {}};
  animation.rotation = {times, {local.rotation, glm::normalize(turned * local.rotation)}};
  scene.timeline.animations.push_back(std::move(animation));
}

void add_lights(Scene& scene, SampleRandom& random) {
  scene.background.horizon = random.color(0.1f, 0.5f);
  scene.background.zenith = random.color(0.2f, 0.8f);
  const int count = 1 + random.below(3);
  for (int i = 0; i < count; ++i) {
    const Quatf aim = glm::angleAxis(random.between(-1.0f, 1.0f), Vec3f(0.0f, 1.0f, 0.0f)) *
                      glm::angleAxis(random.between(-1.2f, 0.2f), Vec3f(1.0f, 0.0f, 0.0f));
    const int node = add_node(scene, {.rotation = aim}, 0);
    const float strength = random.between(1.0f, 2.5f) / static_cast<float>(count);
    scene.lights.push_back({.name = {},
                            .kind = LightKind::kDirectional,
                            .node = node,
                            .color = strength * random.color(0.6f, 1.0f),
                            .angular_diameter = random.between(0.0f, 0.2f)});
  }
}

}  // namespace

Vec3f SampleRandom::color(float low, float high) {
  const float r = between(low, high), g = between(low, high), b = between(low, high);
  return {r, g, b};
}

Quatf SampleRandom::turn() {
  const float a = between(0.0f, 1.0f), b = between(0.0f, 2.0f * kPi), c = between(0.0f, 2.0f * kPi);
  const float s = std::sqrt(1.0f - a), t = std::sqrt(a);
  return {t * std::cos(c), s * std::sin(b), s * std::cos(b), t * std::sin(c)};
}

std::vector<Mesh> unit_meshes_of(const Scene& scene) {
  std::vector<Mesh> meshes;
  for (const Shape& shape : scene.shapes) {
    const Mesh* source = std::get_if<Mesh>(&shape);
    if (!source || source->triangles.empty()) continue;
    Vec3f lower(kInfinity), upper(-kInfinity);
    for (const Vec3f& p : source->positions) lower = glm::min(lower, p), upper = glm::max(upper, p);
    const float radius = 0.5f * glm::length(upper - lower);
    if (!(radius > 0.0f) || !std::isfinite(radius)) continue;
    Mesh mesh{.positions = source->positions, .normals = source->normals, .uvs = source->uvs, .triangles = source->triangles};
    for (Vec3f& p : mesh.positions) p = (p - 0.5f * (lower + upper)) / radius;
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

Scene dataset_scene(const std::vector<Mesh>& meshes, SampleRandom& random) {
  Scene scene;
  scene.timeline.frame_count = 2;
  const Quatf orbit = glm::angleAxis(random.between(-kPi, kPi), Vec3f(0.0f, 1.0f, 0.0f)) *
                      glm::angleAxis(random.between(-0.6f, 0.2f), Vec3f(1.0f, 0.0f, 0.0f));
  add_node(scene, {.rotation = orbit}, -1);
  scene.display = DisplayPlacement{.node = 0, .plane_height = kPlaneHeight};
  add_instance(scene, "wall", wall(-random.between(4.0f, 10.0f)), 0, random);
  const int count = 6 + random.below(9);
  for (int i = 0; i < count; ++i) {
    const Vec3f at(random.between(-5.0f, 5.0f), random.between(-4.5f, 4.5f), random.between(-3.5f, 2.0f));
    const int node =
        add_node(scene, {.translation = at, .rotation = random.turn(), .scale = Vec3f(random.between(0.5f, 1.8f))}, 0);
    add_instance(scene, "object", object_shape(meshes, random), node, random);
    animate(scene, node, random);
  }
  add_lights(scene, random);
  return scene;
}

DatasetCameras dataset_cameras(ViewGrid grid, Vec2i view_size, SampleRandom& random) {
  DatasetCameras cameras;
  cameras.distance_mm = random.between(150.0f, 400.0f);
  cameras.baseline_mm = cameras.distance_mm * std::tan(radians(random.between(0.5f, 2.5f)));
  cameras.pixel_mm = kViewHeightMm / static_cast<float>(view_size.y);
  cameras.optics.panel = {grid.columns * view_size.x, grid.rows * view_size.y, cameras.pixel_mm};
  cameras.optics.model = MultiView{
      .columns = grid.columns, .rows = grid.rows, .distance_mm = cameras.distance_mm, .baseline_mm = cameras.baseline_mm};
  return cameras;
}

}  // namespace lippmann

#include <cmath>

#include "scene/builtin/meshes.hpp"
#include "scene/builtin/scene_builder.hpp"
#include "scene/builtin/scenes.hpp"
#include "scene/builtin/teapot_patches.hpp"
#include "scene/builtin/textures.hpp"

namespace lippmann::builtin {
namespace {

// The edges of a patch's 2 x 44 x 44 triangles are shorter than a pixel in an image of 4096 lines.
constexpr int kPatchSteps = 44;
constexpr int kCups = 3;
constexpr float kOrbitRadius = 3.3f;

Mesh teapot_mesh() {
  Mesh mesh;
  for (const BezierPatch& patch : teapot_patches()) tessellate(patch, kPatchSteps, mesh);
  return mesh;
}

Mesh cup_mesh() {
  const std::vector<Vec2f> outside{{0.0f, 0.06f}, {0.26f, 0.06f}, {0.26f, 0.06f}, {0.30f, 0.0f},  {0.33f, 0.0f},
                                   {0.33f, 0.0f}, {0.31f, 0.08f}, {0.46f, 0.24f}, {0.58f, 0.52f}, {0.66f, 0.78f}};
  const std::vector<Vec2f> inside{{0.645f, 0.80f}, {0.625f, 0.78f}, {0.545f, 0.52f},
                                  {0.43f, 0.27f},  {0.25f, 0.15f},  {0.0f, 0.13f}};
  std::vector<Vec2f> points = outside;
  points.insert(points.end(), inside.begin(), inside.end());
  Mesh mesh = lathe(smooth_profile(points, 5), 72);

  std::vector<Vec3f> ear;
  for (const Vec2f& p :
       smooth_profile({{0.605f, 0.65f}, {0.76f, 0.68f}, {0.88f, 0.56f}, {0.80f, 0.38f}, {0.62f, 0.29f}, {0.465f, 0.285f}}, 6))
    ear.push_back({p, 0.0f});
  append(mesh, tube(ear, std::vector<float>(ear.size(), 0.045f), 16, false));
  return mesh;
}

Mesh saucer_mesh() {
  return lathe(smooth_profile({{0.0f, 0.03f},
                               {0.40f, 0.03f},
                               {0.40f, 0.03f},
                               {0.42f, 0.0f},
                               {0.46f, 0.0f},
                               {0.46f, 0.0f},
                               {0.70f, 0.07f},
                               {0.95f, 0.17f},
                               {0.96f, 0.19f},
                               {0.94f, 0.20f},
                               {0.70f, 0.11f},
                               {0.45f, 0.07f},
                               {0.30f, 0.07f},
                               {0.0f, 0.07f}},
                              3),
               72);
}

Mesh table_edge_mesh(float radius) {
  return lathe(smooth_profile({{radius - 0.5f, -0.42f},
                               {radius - 0.05f, -0.40f},
                               {radius + 0.16f, -0.30f},
                               {radius + 0.20f, -0.15f},
                               {radius + 0.12f, 0.0f},
                               {radius, 0.02f},
                               {radius, 0.02f},
                               {radius, 0.0f}},
                              6),
               180);
}

struct Tableware {
  int cup, saucer, tea;
  int porcelain, gold, tea_surface;
};

void add_cup(SceneBuilder& scene, const Tableware& ware, int orbit, int index) {
  const float angle = 2.0f * kPi * static_cast<float>(index) / kCups;
  const int node = scene.add_node("cup", orbit, at({kOrbitRadius * std::sin(angle), 0.0f, kOrbitRadius * std::cos(angle)}));
  scene.spin(node, kUp, 2, static_cast<float>(index) / kCups);
  const int above = scene.add_node("on the saucer", node, at({0.0f, 0.07f, 0.0f}));
  scene.show("saucer", ware.saucer, ware.gold, node);
  scene.show("cup", ware.cup, ware.porcelain, above);
  scene.show("tea", ware.tea, ware.tea_surface, above);
}

}  // namespace

Scene build_teapot() {
  SceneBuilder scene("teapot");
  PhongSurface marble = glossy(Vec3f(1.0f), 0.25f, 60.0f, 0.12f);
  marble.texture = scene.add_texture(marble_tiles({0.75f, 0.71f, 0.62f}, {0.04f, 0.09f, 0.09f}));

  constexpr float kTableRadius = 4.5f;
  scene.show("table top", disc(kTableRadius, 180, 2.8f), scene.add_material("marble", marble), -1);
  const int gold_material = scene.add_material("gold", polished_metal({0.80f, 0.52f, 0.18f}, 0.15f));
  scene.show("table edge", table_edge_mesh(kTableRadius), gold_material, -1);

  const int pot = scene.add_node("teapot", -1);
  scene.spin(pot, kUp, 1, 0.06f);
  const int upright = scene.add_node("teapot, z up", pot, turned(Vec3f(0.0f), {1, 0, 0}, radians(-90.0f)));
  scene.show("teapot", teapot_mesh(), scene.add_material("glaze", glossy({0.62f, 0.03f, 0.02f}, 0.7f, 90.0f, 0.10f)), upright);

  const int orbit = scene.add_node("circling cups", -1);
  scene.spin(orbit, kUp, -1, 0.1f);
  const Tableware ware{scene.add_shape(cup_mesh()),
                       scene.add_shape(saucer_mesh()),
                       scene.add_shape(Rings{{{0.0f, 0.62f, 0.0f}, kUp, 0.0f, 0.58f}}),
                       scene.add_material("porcelain", glossy({0.86f, 0.84f, 0.78f}, 0.5f, 80.0f, 0.05f)),
                       gold_material,
                       scene.add_material("tea", glossy({0.35f, 0.12f, 0.03f}, 0.3f, 80.0f, 0.2f))};
  for (int i = 0; i < kCups; ++i) add_cup(scene, ware, orbit, i);

  scene.add_light("key", {-8.0f, 7.5f, 6.5f}, {0.95f, 0.88f, 0.78f});
  scene.add_light("fill", {8.0f, 7.0f, 7.0f}, {0.18f, 0.22f, 0.30f});
  scene.set_background({0.10f, 0.13f, 0.15f}, {0.50f, 0.56f, 0.62f});
  constexpr float kPlaneHeight = 9.4f;
  scene.set_display({0.0f, 0.85f, 0.0f}, 0.0f, radians(22.0f), kPlaneHeight, 3.0f * kPlaneHeight);
  scene.add_backdrop({0.10f, 0.20f, 0.22f}, {0.008f, 0.02f, 0.03f});
  return scene.take();
}

}  // namespace lippmann::builtin

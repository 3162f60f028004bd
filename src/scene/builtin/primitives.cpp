#include <cmath>

#include "scene/builtin/meshes.hpp"
#include "scene/builtin/scene_builder.hpp"
#include "scene/builtin/scenes.hpp"

namespace lippmann::builtin {
namespace {

constexpr float kCarouselRadius = 3.0f;
constexpr int kRiders = 6;

/// Returns a new node on the merry-go-round that moves up and down and rotates about its origin. `index` selects the place on
/// the merry-go-round.
int add_rider(SceneBuilder& scene, int carousel, int index, Vec3f spin_axis, int turns) {
  const float angle = 2.0f * kPi * static_cast<float>(index) / kRiders;
  const int place =
      scene.add_node("rider", carousel, at({kCarouselRadius * std::sin(angle), 1.15f, kCarouselRadius * std::cos(angle)}));
  scene.bob(place, kUp, {.amplitude = 0.28f, .cycles = 2, .phase = static_cast<float>(index % 2) * 0.5f});
  const int turning = scene.add_node("turning rider", place);
  scene.spin(turning, glm::normalize(spin_axis), turns);
  return turning;
}

void add_capped_cylinder(SceneBuilder& scene, int node, int side, int caps) {
  constexpr float kRadius = 0.52f, kHalf = 0.62f;
  scene.show("cylinder", Cylinders{{{0.0f, -kHalf, 0.0f}, {0.0f, kHalf, 0.0f}, kRadius}}, side, node);
  scene.show("cylinder's caps", Rings{{{0.0f, kHalf, 0.0f}, kUp, 0.0f, kRadius}, {{0.0f, -kHalf, 0.0f}, -kUp, 0.0f, kRadius}},
             caps, node);
}

void add_pipe(SceneBuilder& scene, int node, int outside, int inside) {
  constexpr float kOuter = 0.62f, kInner = 0.44f, kHalf = 0.5f;
  scene.show("pipe", Cylinders{{{0.0f, -kHalf, 0.0f}, {0.0f, kHalf, 0.0f}, kOuter}}, outside, node);
  scene.show("pipe's bore", Cylinders{{{0.0f, -kHalf, 0.0f}, {0.0f, kHalf, 0.0f}, kInner}}, inside, node);
  scene.show("pipe's rims", Rings{{{0.0f, kHalf, 0.0f}, kUp, kInner, kOuter}, {{0.0f, -kHalf, 0.0f}, -kUp, kInner, kOuter}},
             outside, node);
}

void add_riders(SceneBuilder& scene, int carousel) {
  const int red = scene.add_material("red", glossy({0.80f, 0.07f, 0.06f}, 0.5f, 70.0f, 0.06f));
  const int orange = scene.add_material("orange", glossy({0.95f, 0.33f, 0.03f}, 0.4f, 50.0f));
  const int yellow = scene.add_material("yellow", glossy({0.95f, 0.68f, 0.06f}, 0.4f, 50.0f));
  const int green = scene.add_material("green", glossy({0.08f, 0.48f, 0.18f}, 0.5f, 60.0f));
  const int blue = scene.add_material("blue", glossy({0.04f, 0.20f, 0.65f}, 0.5f, 70.0f, 0.08f));
  const int violet = scene.add_material("violet", glossy({0.38f, 0.10f, 0.55f}, 0.5f, 60.0f, 0.05f));
  const int chrome = scene.add_material("chrome", glossy(Vec3f(0.10f), 0.9f, 200.0f, 0.80f));
  const int white = scene.add_material("white", glossy({0.88f, 0.86f, 0.82f}, 0.3f, 40.0f));

  scene.show("box", Boxes{{Vec3f(-0.52f), Vec3f(0.52f)}}, red, add_rider(scene, carousel, 0, {1.0f, 1.0f, 0.3f}, 2));
  add_capped_cylinder(scene, add_rider(scene, carousel, 1, {1.0f, 0.0f, 0.4f}, 1), orange, white);
  const int ball = add_rider(scene, carousel, 2, {0.3f, 0.0f, 1.0f}, 2);
  scene.show("sphere", Spheres{{Vec3f(0.0f), 0.62f}}, yellow, ball);
  scene.show("chrome spheres", Spheres{{{0.0f, 0.80f, 0.0f}, 0.20f}, {{0.0f, -0.80f, 0.0f}, 0.20f}}, chrome, ball);
  const int cone_node =
      scene.add_node("cone's middle", add_rider(scene, carousel, 3, {0.5f, 0.3f, 1.0f}, 1), at({0.0f, -0.5f, 0.0f}));
  scene.show("cone", cone(0.66f, 1.25f, 96), green, cone_node);
  scene.show("torus", torus(0.55f, 0.21f, 128, 48), blue, add_rider(scene, carousel, 4, {1.0f, 0.2f, 0.0f}, 2));
  add_pipe(scene, add_rider(scene, carousel, 5, {0.5f, 0.1f, 1.0f}, 1), violet, white);
}

void add_glass_ball(SceneBuilder& scene) {
  PhongSurface glass = glossy({0.75f, 0.90f, 0.95f}, 0.9f, 250.0f, 0.10f);
  glass.diffuse = 0.05f;
  glass.ambient = 0.02f;
  glass.opacity = 0.12f;
  glass.ior = 1.5f;
  const int center = scene.add_node("glass ball", -1, at({0.0f, 1.75f, 0.0f}));
  scene.bob(center, kUp, {.amplitude = 0.15f, .cycles = 1, .phase = 0.25f});
  scene.show("glass ball", Spheres{{Vec3f(0.0f), 1.2f}}, scene.add_material("glass", glass), center);

  const int leaning = scene.add_node("where the ring leans", center);
  scene.spin(leaning, kUp, -2);
  const int ring = scene.add_node("ring", leaning, turned(Vec3f(0.0f), {0.0f, 0.0f, 1.0f}, radians(24.0f)));
  const int gold = scene.add_material("gold", polished_metal({0.90f, 0.50f, 0.10f}, 0.20f));
  scene.show("ring", Rings{{Vec3f(0.0f), kUp, 1.55f, 1.85f}, {Vec3f(0.0f), kUp, 1.93f, 2.0f}}, gold, ring);
}

void add_floor(SceneBuilder& scene) {
  const int light = scene.add_material("floor, light", glossy({0.78f, 0.72f, 0.60f}, 0.0f, 1.0f, 0.06f));
  const int dark = scene.add_material("floor, dark", glossy({0.02f, 0.07f, 0.12f}, 0.0f, 1.0f, 0.12f));
  Rings rings[2];
  constexpr float kWidth = 0.75f;
  for (int i = 0; i < 6; ++i)
    rings[i % 2].push_back({Vec3f(0.0f), kUp, kWidth * static_cast<float>(i), kWidth * static_cast<float>(i + 1)});
  scene.show("floor", std::move(rings[0]), dark, -1);
  scene.show("floor", std::move(rings[1]), light, -1);
  scene.show("floor's edge", Cylinders{{{0.0f, -0.3f, 0.0f}, Vec3f(0.0f), 6.0f * kWidth}}, dark, -1);
}

}  // namespace

Scene build_primitives() {
  SceneBuilder scene("primitives");
  add_floor(scene);
  const int carousel = scene.add_node("merry-go-round", -1);
  scene.spin(carousel, kUp, 1);
  add_riders(scene, carousel);
  add_glass_ball(scene);

  scene.add_light("key", {-7.0f, 11.0f, 7.0f}, {0.90f, 0.85f, 0.78f});
  scene.add_light("fill", {2.0f, 10.0f, 24.0f}, {0.25f, 0.28f, 0.34f});
  scene.set_background({0.22f, 0.18f, 0.16f}, {0.70f, 0.75f, 0.84f});
  scene.set_max_depth(8);
  constexpr float kPlaneHeight = 9.2f;
  scene.set_display({0.0f, 0.55f, 0.0f}, 0.0f, radians(20.0f), kPlaneHeight, 3.0f * kPlaneHeight);
  scene.add_backdrop({0.60f, 0.44f, 0.30f}, {0.13f, 0.07f, 0.06f});
  return scene.take();
}

}  // namespace lippmann::builtin

// The scene "small-balls": the sphereflake of Eric Haines' Standard Procedural Databases ("A Proposal for Standard Graphics
// Environments", IEEE CG&A 7(11), 1987). Every sphere carries nine spheres of a third of its size, at nine of the twelve
// neighbouring positions in a close packing of spheres: six around the equator and three above it.
#include <cmath>

#include "scene/builtin/scene_builder.hpp"
#include "scene/builtin/scenes.hpp"

namespace lippmann::builtin {
namespace {

constexpr int kChildren = 9;
constexpr float kChildSize = 1.0f / 3.0f;

Vec3f child_direction(int child) {
  const bool around = child < 6;
  const float azimuth =
      around ? radians(60.0f * static_cast<float>(child)) : radians(30.0f + 120.0f * static_cast<float>(child));
  const float height = around ? 0.0f : std::sqrt(2.0f / 3.0f);
  const float outwards = std::sqrt(1.0f - height * height);
  return {outwards * std::cos(azimuth), height, outwards * std::sin(azimuth)};
}

/// Returns the transform of one of the nine spheres on a sphere around the origin. `radius` is the radius of the carrying
/// sphere. +y of the transform points outwards.
Transform child_place(int child, float radius) {
  const Vec3f direction = child_direction(child);
  return {(1.0f + kChildSize) * radius * direction, Quatf(kUp, direction), Vec3f(1.0f)};
}

/// Adds the descendants of a sphere that are `generation` generations below it.
void collect(const Affine3f& place, float radius, int generation, Spheres& spheres) {
  if (generation == 0) {
    spheres.push_back({place.translation, radius});
    return;
  }
  for (int child = 0; child < kChildren; ++child) {
    const Transform t = child_place(child, radius);
    collect(place * Affine3f{glm::mat3_cast(t.rotation), t.translation}, kChildSize * radius, generation - 1, spheres);
  }
}

}  // namespace

Scene build_small_balls() {
  constexpr float kRadius[] = {1.0f, 1.0f / 3.0f, 1.0f / 9.0f};
  SceneBuilder scene("small-balls");
  const int materials[] = {
      scene.add_material("chrome", glossy({0.10f, 0.10f, 0.12f}, 0.9f, 200.0f, 0.80f)),
      scene.add_material("indigo", glossy({0.06f, 0.07f, 0.32f}, 0.6f, 80.0f, 0.25f)),
      scene.add_material("teal", glossy({0.02f, 0.32f, 0.36f}, 0.5f, 60.0f)),
      scene.add_material("coral", glossy({0.85f, 0.22f, 0.10f}, 0.4f, 40.0f)),
      scene.add_material("cream", glossy({0.90f, 0.74f, 0.42f}, 0.3f, 30.0f)),
  };

  const int root = scene.add_node("flake", -1);
  scene.spin(root, kUp, 1);
  scene.show("ball", Spheres{{Vec3f(0.0f), kRadius[0]}}, materials[0], root);
  const int first_generation = scene.add_shape(Spheres{{Vec3f(0.0f), kRadius[1]}});
  int cluster[3];
  for (int generation = 0; generation < 3; ++generation) {
    Spheres spheres;
    collect({}, kRadius[2], generation, spheres);
    cluster[generation] = scene.add_shape(std::move(spheres));
  }
  for (int i = 0; i < kChildren; ++i) {
    const int branch = scene.add_node("branch", root, child_place(i, kRadius[0]));
    scene.spin(branch, kUp, i % 2 == 0 ? 2 : -2);
    scene.show("ball", first_generation, materials[1], branch);
    for (int j = 0; j < kChildren; ++j) {
      const int twig = scene.add_node("twig", branch, child_place(j, kRadius[1]));
      scene.spin(twig, kUp, j % 2 == 0 ? -3 : 3);
      for (int generation = 0; generation < 3; ++generation)
        scene.show("balls", cluster[generation], materials[2 + generation], twig);
    }
  }

  const int floor = scene.add_material("floor", glossy({0.03f, 0.035f, 0.06f}, 0.3f, 50.0f, 0.30f));
  scene.show("floor", Rings{{{0.0f, -1.3f, 0.0f}, kUp, 0.0f, 2.0f}}, floor, -1);
  scene.show("floor's edge", Rings{{{0.0f, -1.3f, 0.0f}, kUp, 2.0f, 2.06f}}, materials[4], -1);

  scene.add_light("key", {-5.0f, 5.0f, 5.0f}, {0.95f, 0.90f, 0.82f});
  scene.add_light("fill", {6.0f, 4.0f, 2.0f}, {0.25f, 0.30f, 0.42f});
  scene.set_background({0.06f, 0.07f, 0.12f}, {0.55f, 0.62f, 0.75f});
  constexpr float kPlaneHeight = 4.8f;
  scene.set_display({0.0f, -0.05f, 0.0f}, 0.0f, radians(18.0f), kPlaneHeight, 3.0f * kPlaneHeight);
  scene.add_backdrop({0.10f, 0.10f, 0.20f}, {0.006f, 0.007f, 0.02f});
  return scene.take();
}

}  // namespace lippmann::builtin

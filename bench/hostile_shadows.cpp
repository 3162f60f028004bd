#include "bench/hostile_builders.hpp"
#include "bench/hostile_parts.hpp"

namespace lippmann::bench {
namespace {

constexpr float kTurnPerFrame = radians(10.0f);

void add_bar_and_floor(Scene& scene) {
  add_floor(scene, 8.0f, add_material(scene, matte({0.6f, 0.57f, 0.52f})));
  const int hub = add_node(scene, -1, {0.0f, 0.35f, 0.0f});
  turn(scene, hub, kUp, [](float frame) { return 0.3f + kTurnPerFrame * frame; });
  show(scene, box_mesh(Vec3f(0.0f), {1.3f, 0.14f, 0.14f}), add_material(scene, matte({0.7f, 0.3f, 0.15f})), hub);
  show(scene, box_mesh({0.0f, 0.16f, 0.0f}, {0.08f, 0.32f, 0.08f}), add_material(scene, matte(Vec3f(0.3f))));
  look_at(scene, {0.0f, 0.15f, 0.0f}, radians(15.0f), radians(32.0f), 1.5f, 4.0f);
}

/// A sun of 3 x 3 texels at the front left gives most of the light.
EnvironmentMap sky_with_sun() {
  constexpr int kWidth = 256, kHeight = 128, kSunColumn = 205, kSunRow = 36;
  EnvironmentMap map;
  map.radiance = Image(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool sun = std::abs(x - kSunColumn) <= 1 && std::abs(y - kSunRow) <= 1;
      const Vec3f radiance = sun ? Vec3f(950.0f, 850.0f, 700.0f) : Vec3f(0.08f, 0.12f, 0.2f);
      for (int c = 0; c < 3; ++c) map.radiance.pixel(x, y)[c] = radiance[c];
    }
  return map;
}

}  // namespace

Scene bar_below_sun() {
  Scene scene = empty_scene("bar-sun");
  add_bar_and_floor(scene);
  scene.background.map = sky_with_sun();
  return scene;
}

Scene bar_below_lamp() {
  Scene scene = empty_scene("bar-lamp");
  add_bar_and_floor(scene);
  add_lamp(scene, {-0.3f, 1.6f, -0.2f}, 0.3f, Vec3f(17.0f, 16.0f, 14.0f));
  return scene;
}

}  // namespace lippmann::bench

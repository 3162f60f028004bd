// The scene "gears": a planetary gear train whose ring drives more gears. The unit of length is the module of the gears.
//
// Every gear makes a whole number w of turns per loop, so that the loop is seamless. The ring makes 1 turn and the carrier 2.
// The turns of sun and planets follow from Willis' equation. The ring has 36 teeth inside, the sun and each planet have 12:
// - Sun: (w_sun - w_carrier) / (w_ring - w_carrier) = -36/12, so the sun makes 5 turns.
// - Planets: (w_planet - w_carrier) / (w_ring - w_carrier) = 36/12, so each planet makes -1 turn.
#include <cmath>

#include "scene/builtin/gear.hpp"
#include "scene/builtin/meshes.hpp"
#include "scene/builtin/scene_builder.hpp"
#include "scene/builtin/scenes.hpp"
#include "scene/builtin/textures.hpp"

namespace lippmann::builtin {
namespace {

constexpr int kSun = 12, kPlanet = 12, kRingInside = 36, kRingOutside = 48, kPlanets = 4;
constexpr int kRingTurns = 1, kCarrierTurns = 2, kSunTurns = 5, kPlanetTurns = -1;
constexpr Vec3f kAxis(0.0f, 0.0f, 1.0f);
constexpr float kPlateDepth = -19.0f;

struct Metals {
  int brass, steel, bronze, gold, blued, ruby;
};

struct Gear {
  Vec3f center{0.0f};
  int teeth = 0, turns = 0;
  float angle = 0.0f;
};

/// Returns a gear that meshes with `driver`. `direction` is the angle of the line from the driver to the gear. The resulting
/// number of turns must be whole.
Gear beside(const Gear& driver, int teeth, float direction) {
  Gear gear;
  const float distance = pitch_radius(driver.teeth) + pitch_radius(teeth);
  gear.center = driver.center + distance * Vec3f(std::cos(direction), std::sin(direction), 0.0f);
  gear.teeth = teeth;
  gear.turns = -driver.turns * driver.teeth / teeth;
  gear.angle = meshing_angle(driver.teeth, driver.angle, teeth, direction);
  return gear;
}

Gear on_shaft(const Gear& gear, int teeth, float z) {
  Gear other = gear;
  other.center.z = z;
  other.teeth = teeth;
  return other;
}

int add_turning_node(SceneBuilder& scene, const char* name, int parent, Vec3f center, int turns, float angle) {
  const int node = scene.add_node(name, parent, at(center));
  scene.spin(node, kAxis, turns, angle / (2.0f * kPi));
  return node;
}

int add_gear(SceneBuilder& scene, const Gear& gear, const GearBlank& blank, int metal) {
  const int node = add_turning_node(scene, "gear", -1, gear.center, gear.turns, gear.angle);
  scene.show("gear", gear_mesh(gear.teeth, blank), metal, node);
  return node;
}

void add_shaft(SceneBuilder& scene, int parent, Vec3f center, float back, float front, float radius, const Metals& metals) {
  const int node = scene.add_node("shaft", parent, at({center.x, center.y, 0.0f}));
  scene.show("shaft", Cylinders{{{0.0f, 0.0f, back}, {0.0f, 0.0f, front}, radius}}, metals.steel, node);
  scene.show("shaft end", Rings{{{0.0f, 0.0f, front}, kAxis, 0.45f * radius, radius}}, metals.steel, node);
  scene.show("jewel", Spheres{{{0.0f, 0.0f, front - 0.25f * radius}, 0.5f * radius}}, metals.ruby, node);
}

struct Trim {
  float face;
  float band_radius, screw_radius;
  int screws;
  int band_metal;
};

void add_trim(SceneBuilder& scene, int node, const Trim& trim, const Metals& metals) {
  Mesh band;
  const Affine3f facing_z{glm::mat3_cast(glm::angleAxis(radians(90.0f), Vec3f(1, 0, 0))), {0.0f, 0.0f, trim.face}};
  append(band, torus(trim.band_radius, 0.35f, 160, 16), facing_z);
  scene.show("band", std::move(band), trim.band_metal, node);
  Spheres heads;
  for (int i = 0; i < trim.screws; ++i) {
    const float angle = 2.0f * kPi * (static_cast<float>(i) + 0.5f) / static_cast<float>(trim.screws);
    heads.push_back({{trim.screw_radius * std::cos(angle), trim.screw_radius * std::sin(angle), trim.face - 0.45f}, 0.95f});
  }
  scene.show("screws", std::move(heads), metals.blued, node);
}

void add_planetary_set(SceneBuilder& scene, const Gear& ring, const Metals& metals) {
  const GearBlank blank{.thickness = 5.0f, .bore_radius = 1.6f};
  const float distance = pitch_radius(kSun) + pitch_radius(kPlanet);

  const float ring_node_angle = ring.angle;
  const int ring_node = add_turning_node(scene, "ring", -1, ring.center, kRingTurns, ring_node_angle);
  scene.show("ring", ring_gear_mesh(kRingInside, kRingOutside, blank), metals.brass, ring_node);
  add_trim(scene, ring_node, {0.5f * blank.thickness, 19.9f, 21.4f, 16, metals.gold}, metals);

  // The gears mesh if their angles are derived in this order.
  const float planet_angle = static_cast<float>(kRingInside) / kPlanet * ring.angle;
  const float sun_angle = meshing_angle(kPlanet, planet_angle, kSun, kPi);
  const int sun = add_turning_node(scene, "sun", -1, ring.center, kSunTurns, sun_angle);
  scene.show("sun", gear_mesh(kSun, blank), metals.gold, sun);
  add_shaft(scene, -1, ring.center, kPlateDepth, 5.5f, 1.6f, metals);

  const int carrier = add_turning_node(scene, "carrier", -1, ring.center, kCarrierTurns, 0.0f);
  const int planet_shape = scene.add_shape(gear_mesh(kPlanet, blank));
  for (int i = 0; i < kPlanets; ++i) {
    const float direction = 2.0f * kPi * static_cast<float>(i) / kPlanets;
    const Vec3f center = distance * Vec3f(std::cos(direction), std::sin(direction), 0.0f);
    const float angle = meshing_angle(kSun, sun_angle, kPlanet, direction);
    scene.show("planet", planet_shape, metals.steel,
               add_turning_node(scene, "planet", carrier, center, kPlanetTurns - kCarrierTurns, angle));
    add_shaft(scene, carrier, center, -2.0f, 4.9f, 1.6f, metals);
  }
}

Texture perlage(Vec3f color) {
  return paint("perlage", 256, 256, [=](Vec2f uv) {
    const Vec2f p = 4.0f * uv;
    Vec2f best(0.0f);
    for (int row = static_cast<int>(std::floor(p.y)) - 1; row <= static_cast<int>(std::floor(p.y)) + 1; ++row)
      for (int column = static_cast<int>(std::floor(p.x)) - 1; column <= static_cast<int>(std::floor(p.x)) + 1; ++column) {
        const Vec2f from_center = p - Vec2f(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f);
        if (glm::length(from_center) < 0.78f) best = from_center;
      }
    const float radius = glm::length(best), around = std::atan2(best.y, best.x);
    const float sheen = 0.5f + 0.5f * std::cos(2.0f * around - 0.9f);
    const float rings = 0.5f + 0.5f * std::cos(40.0f * radius);
    return color * (0.62f + 0.5f * sheen * radius / 0.78f + 0.06f * rings);
  });
}

}  // namespace

Scene build_gears() {
  SceneBuilder scene("gears");
  const Metals metals{scene.add_material("brass", polished_metal({0.76f, 0.50f, 0.16f}, 0.20f)),
                      scene.add_material("steel", polished_metal({0.50f, 0.53f, 0.58f}, 0.25f)),
                      scene.add_material("bronze", polished_metal({0.52f, 0.24f, 0.09f}, 0.15f)),
                      scene.add_material("gold", polished_metal({0.95f, 0.62f, 0.20f}, 0.25f)),
                      scene.add_material("blued steel", polished_metal({0.05f, 0.10f, 0.42f}, 0.25f)),
                      scene.add_material("ruby", glossy({0.70f, 0.02f, 0.08f}, 0.9f, 60.0f, 0.1f))};

  const Gear ring{{-7.0f, -6.0f, 0.0f}, kRingOutside, kRingTurns, 0.0f};
  add_planetary_set(scene, ring, metals);

  const GearBlank wheel{
      .thickness = 4.0f, .bore_radius = 1.4f, .spokes = 5, .spoke_width = 2.2f, .rim_width = 1.8f, .hub_radius = 3.0f};
  const GearBlank pinion{.thickness = 5.0f, .bore_radius = 1.4f};
  const Gear upper = beside(ring, 24, radians(46.0f)), lower = beside(ring, 16, radians(-34.0f)),
             left = beside(ring, 12, radians(121.0f));
  add_gear(scene, upper, wheel, metals.steel);
  const int lower_node = add_gear(scene, lower, pinion, metals.bronze);
  add_trim(scene, lower_node, {0.5f * pinion.thickness, 5.6f, 4.0f, 6, metals.gold}, metals);
  add_gear(scene, left, pinion, metals.gold);

  const Gear front = on_shaft(upper, 12, 8.0f), front_partner = beside(front, 12, radians(-95.0f));
  add_gear(scene, front, {.thickness = 4.0f, .bore_radius = 1.4f}, metals.gold);
  add_gear(scene, front_partner, {.thickness = 3.0f, .bore_radius = 1.2f}, metals.brass);
  const Gear back = on_shaft(upper, 40, -9.5f), back_partner = beside(back, 20, radians(183.0f));
  const GearBlank great_wheel{
      .thickness = 3.0f, .bore_radius = 1.4f, .spokes = 6, .spoke_width = 3.0f, .rim_width = 2.5f, .hub_radius = 4.0f};
  add_gear(scene, back, great_wheel, metals.bronze);
  add_gear(scene, back_partner, {.thickness = 3.0f, .bore_radius = 1.4f}, metals.brass);

  for (const Gear& gear : {upper, lower, left})
    add_shaft(scene, -1, gear.center, kPlateDepth, gear.center.z + 4.0f, 1.4f, metals);
  add_shaft(scene, -1, front.center, kPlateDepth, 11.5f, 1.4f, metals);
  add_shaft(scene, -1, front_partner.center, kPlateDepth, 10.5f, 1.2f, metals);
  add_shaft(scene, -1, back_partner.center, kPlateDepth, -6.5f, 1.4f, metals);

  PhongSurface plate = polished_metal(Vec3f(1.0f), 0.06f);
  plate.texture = scene.add_texture(perlage({0.15f, 0.17f, 0.22f}));
  scene.show("plate", rectangle({0.0f, 0.0f, kPlateDepth}, {110.0f, 0.0f, 0.0f}, {0.0f, 80.0f, 0.0f}, {11.0f, 8.0f}),
             scene.add_material("plate", plate), -1);

  scene.add_light("key", {-45.0f, 50.0f, 60.0f}, {1.0f, 0.93f, 0.82f});
  scene.add_light("fill", {45.0f, 25.0f, 200.0f}, {0.20f, 0.25f, 0.34f});
  scene.set_background({0.22f, 0.20f, 0.20f}, {1.0f, 0.98f, 0.95f});
  constexpr float kPlaneHeight = 70.0f;
  scene.set_display({0.0f, 0.0f, -1.0f}, radians(12.0f), radians(10.0f), kPlaneHeight, 3.0f * kPlaneHeight);
  return scene.take();
}

}  // namespace lippmann::builtin

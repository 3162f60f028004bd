// The scene "room": a furnished room with a moving clock, globe, orrery, ornament and ball. The unit of length is the metre.
#include <cmath>

#include "scene/builtin/meshes.hpp"
#include "scene/builtin/scene_builder.hpp"
#include "scene/builtin/scenes.hpp"
#include "scene/builtin/textures.hpp"

namespace lippmann::builtin {
namespace {

constexpr Vec3f kRight(1.0f, 0.0f, 0.0f), kTowardsViewer(0.0f, 0.0f, 1.0f);
constexpr float kHalfWidth = 2.2f, kHeight = 3.95f, kBack = -2.6f, kFront = 0.25f, kFloorFront = 1.3f;
constexpr Vec3f kTable(0.1f, 0.0f, -0.35f);

struct Materials {
  int wood, brass, ivory, white, dark;
};

Box box(Vec3f center, Vec3f size) { return {center - 0.5f * size, center + 0.5f * size}; }

int textured(SceneBuilder& scene, const char* name, Texture texture, PhongSurface surface) {
  surface.texture = scene.add_texture(std::move(texture));
  return scene.add_material(name, surface);
}

void add_walls(SceneBuilder& scene, const Materials& m) {
  const float middle = 0.5f * (kBack + kFront), half_depth = 0.5f * (kFront - kBack);
  const int boards = textured(scene, "floor boards", wood_boards({0.42f, 0.22f, 0.09f}, {0.20f, 0.09f, 0.035f}, 8),
                              glossy(Vec3f(1.0f), 0.15f, 30.0f, 0.07f));
  scene.show("floor",
             rectangle({0.0f, 0.0f, 0.5f * (kBack + kFloorFront)}, {kHalfWidth, 0.0f, 0.0f},
                       {0.0f, 0.0f, -0.5f * (kFloorFront - kBack)}, {2.0f, 1.6f}),
             boards, -1);
  const int paper =
      textured(scene, "wallpaper", striped_plaster({0.42f, 0.50f, 0.42f}, {0.34f, 0.43f, 0.36f}, 4), matte(Vec3f(1.0f)));
  Mesh walls;
  append(walls, rectangle({0.0f, 0.5f * kHeight, kBack}, {kHalfWidth, 0.0f, 0.0f}, {0.0f, 0.5f * kHeight, 0.0f}, {4.0f, 3.0f}));
  append(walls, rectangle({-kHalfWidth, 0.5f * kHeight, middle}, {0.0f, 0.0f, -half_depth}, {0.0f, 0.5f * kHeight, 0.0f},
                          {2.6f, 3.0f}));
  append(walls,
         rectangle({kHalfWidth, 0.5f * kHeight, middle}, {0.0f, 0.0f, half_depth}, {0.0f, 0.5f * kHeight, 0.0f}, {2.6f, 3.0f}));
  scene.show("walls", std::move(walls), paper, -1);
  scene.show("ceiling", rectangle({0.0f, kHeight, middle}, {kHalfWidth, 0.0f, 0.0f}, {0.0f, 0.0f, half_depth}), m.ivory, -1);

  Boxes panelling;
  for (const float y : {0.08f, 0.95f, kHeight - 0.06f}) {
    const float height = y < 0.9f ? 0.16f : y < 2.0f ? 0.06f : 0.12f, deep = 0.05f;
    panelling.push_back(box({0.0f, y, kBack + 0.5f * deep}, {2.0f * kHalfWidth, height, deep}));
    for (const float side : {-1.0f, 1.0f})
      panelling.push_back(box({side * (kHalfWidth - 0.5f * deep), y, middle}, {deep, height, 2.0f * half_depth}));
  }
  scene.show("skirting and rails", std::move(panelling), m.ivory, -1);
  const int carpet_material = textured(
      scene, "carpet", carpet({0.36f, 0.035f, 0.03f}, {0.62f, 0.42f, 0.16f}, {0.03f, 0.06f, 0.16f}), matte(Vec3f(1.0f)));
  scene.show("carpet", rectangle({0.0f, 0.008f, -0.4f}, {1.65f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.35f}), carpet_material, -1);
}

void add_table(SceneBuilder& scene, const Materials& m) {
  const int node = scene.add_node("table", -1, at(kTable));
  Mesh table = lathe(
      smooth_profile(
          {{0.0f, 0.72f}, {0.60f, 0.72f}, {0.68f, 0.74f}, {0.70f, 0.77f}, {0.68f, 0.80f}, {0.66f, 0.80f}, {0.0f, 0.80f}}, 5),
      96);
  append(table, lathe(smooth_profile({{0.34f, 0.02f},
                                      {0.34f, 0.05f},
                                      {0.20f, 0.09f},
                                      {0.08f, 0.14f},
                                      {0.06f, 0.20f},
                                      {0.11f, 0.30f},
                                      {0.12f, 0.38f},
                                      {0.06f, 0.48f},
                                      {0.05f, 0.56f},
                                      {0.10f, 0.66f},
                                      {0.20f, 0.73f}},
                                     5),
                      64));
  scene.show("table", std::move(table), m.wood, node);
}

void add_vase(SceneBuilder& scene, Vec3f place, float size, int material) {
  const int node = scene.add_node("vase", -1, at(place, size));
  scene.show("vase",
             lathe(smooth_profile({{0.0f, 0.0f},
                                   {0.24f, 0.0f},
                                   {0.24f, 0.0f},
                                   {0.26f, 0.03f},
                                   {0.22f, 0.08f},
                                   {0.34f, 0.30f},
                                   {0.42f, 0.55f},
                                   {0.36f, 0.80f},
                                   {0.17f, 1.00f},
                                   {0.14f, 1.10f},
                                   {0.22f, 1.22f},
                                   {0.20f, 1.23f},
                                   {0.12f, 1.10f},
                                   {0.15f, 1.00f},
                                   {0.30f, 0.78f},
                                   {0.0f, 0.5f}},
                                  6),
                   72),
             material, node);
}

void add_mirror(SceneBuilder& scene, const Materials& m) {
  constexpr float kRadius = 0.68f;
  // The mirror is turned so that the viewer sees the table in it.
  const int hook = scene.add_node("mirror's hook", -1, turned({-1.0f, 2.15f, kBack + 0.26f}, kUp, radians(14.0f)));
  const int node = scene.add_node("mirror", hook, turned(Vec3f(0.0f), kRight, radians(90.0f + 9.0f)));
  const int glass = scene.add_material("mirror", glossy(Vec3f(0.02f), 0.0f, 1.0f, 0.92f));
  scene.show("mirror", Rings{{Vec3f(0.0f), kUp, 0.0f, kRadius}}, glass, node);
  Mesh frame = torus(kRadius + 0.03f, 0.06f, 128, 24);
  append(frame, torus(kRadius + 0.10f, 0.035f, 128, 16));
  scene.show("mirror's frame", std::move(frame), m.brass, node);
}

void add_ornament(SceneBuilder& scene, const Materials& m) {
  std::vector<Vec3f> knot;
  constexpr int kPoints = 288;
  for (int i = 0; i < kPoints; ++i) {
    const float t = 2.0f * kPi * static_cast<float>(i) / kPoints;
    const float radius = 0.26f + 0.11f * std::cos(3.0f * t);
    knot.push_back({radius * std::cos(2.0f * t), 0.13f * std::sin(3.0f * t), radius * std::sin(2.0f * t)});
  }
  const int stand = scene.add_node("ornament's stand", -1, at(kTable + Vec3f(0.08f, 0.80f, 0.0f)));
  scene.show(
      "ornament's stand",
      lathe(smooth_profile({{0.17f, 0.0f}, {0.17f, 0.03f}, {0.05f, 0.06f}, {0.03f, 0.14f}, {0.05f, 0.17f}, {0.0f, 0.19f}}, 6),
            48),
      m.dark, stand);
  const int tilted = scene.add_node("ornament, tilted", stand, turned({0.0f, 0.55f, 0.0f}, kRight, radians(90.0f)));
  const int ornament = scene.add_node("ornament", tilted);
  scene.spin(ornament, {0.0f, 0.0f, 1.0f}, 2);
  scene.show("ornament", tube(knot, std::vector<float>(knot.size(), 0.055f), 28, true), m.brass, ornament);
}

void add_globe(SceneBuilder& scene, const Materials& m) {
  const int stand = scene.add_node("globe's stand", -1, at({-1.42f, 0.0f, 0.1f}));
  Mesh foot = lathe(smooth_profile({{0.26f, 0.0f},
                                    {0.26f, 0.04f},
                                    {0.10f, 0.09f},
                                    {0.045f, 0.16f},
                                    {0.06f, 0.30f},
                                    {0.035f, 0.40f},
                                    {0.05f, 0.50f},
                                    {0.0f, 0.53f}},
                                   6),
                    48);
  scene.show("globe's stand", std::move(foot), m.wood, stand);
  const int axis = scene.add_node("globe's axis", stand, turned({0.0f, 0.95f, 0.0f}, kTowardsViewer, radians(-23.4f)));
  const Affine3f upright{glm::mat3_cast(glm::angleAxis(radians(90.0f), kRight)), Vec3f(0.0f)};
  Mesh meridian;
  append(meridian, torus(0.42f, 0.018f, 96, 12), upright);
  scene.show("meridian", std::move(meridian), m.brass, axis);
  const int ball = scene.add_node("globe", axis);
  scene.spin(ball, kUp, 2);
  const int map =
      textured(scene, "globe", globe({0.03f, 0.12f, 0.28f}, {0.10f, 0.24f, 0.06f}), glossy(Vec3f(1.0f), 0.4f, 60.0f));
  scene.show("globe", uv_sphere(0.38f, 96, 48), map, ball);
}

void add_clock(SceneBuilder& scene, const Materials& m) {
  const int clock = scene.add_node("clock", -1, at({1.35f, 0.0f, kBack + 0.2f}));
  scene.show("clock's case",
             Boxes{box({0.0f, 0.15f, 0.0f}, {0.66f, 0.30f, 0.38f}), box({0.0f, 2.15f, 0.0f}, {0.66f, 0.62f, 0.36f}),
                   box({0.0f, 2.50f, 0.0f}, {0.76f, 0.08f, 0.42f}), box({-0.25f, 1.05f, 0.0f}, {0.07f, 1.6f, 0.30f}),
                   box({0.25f, 1.05f, 0.0f}, {0.07f, 1.6f, 0.30f}), box({0.0f, 1.05f, -0.13f}, {0.46f, 1.6f, 0.04f})},
             m.wood, clock);
  const int dial = scene.add_node("dial", clock, turned({0.0f, 2.15f, 0.185f}, kRight, radians(90.0f)));
  scene.show("dial", Rings{{Vec3f(0.0f), kUp, 0.0f, 0.245f}}, m.white, dial);
  scene.show("dial's rim", torus(0.25f, 0.02f, 72, 12), m.brass, dial);
  const int face = scene.add_node("face", clock, at({0.0f, 2.15f, 0.195f}));
  Boxes marks;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec3f direction(std::round(std::sin(0.5f * kPi * static_cast<float>(quarter))),
                          std::round(std::cos(0.5f * kPi * static_cast<float>(quarter))), 0.0f);
    marks.push_back(box(0.20f * direction, Vec3f(0.02f) + 0.03f * glm::abs(direction)));
  }
  scene.show("marks", std::move(marks), m.dark, face);
  const int hour = scene.add_node("hour hand", face), minute = scene.add_node("minute hand", face);
  scene.spin(hour, kTowardsViewer, -1, 0.08f);
  scene.spin(minute, kTowardsViewer, -12);
  scene.show("hour hand", Boxes{box({0.0f, 0.06f, 0.01f}, {0.026f, 0.15f, 0.01f})}, m.dark, hour);
  scene.show("minute hand", Boxes{box({0.0f, 0.09f, 0.025f}, {0.018f, 0.22f, 0.01f})}, m.dark, minute);

  const int pendulum = scene.add_node("pendulum", clock, at({0.0f, 1.85f, 0.05f}));
  scene.swing(pendulum, kTowardsViewer, {.amplitude = radians(7.0f), .cycles = 8, .phase = 0.0f});
  scene.show("pendulum's rod", Cylinders{{Vec3f(0.0f), {0.0f, -1.1f, 0.0f}, 0.012f}}, m.brass, pendulum);
  scene.show("pendulum's bob", Spheres{{{0.0f, -1.16f, 0.0f}, 0.115f}}, m.brass, pendulum);
}

void add_orrery(SceneBuilder& scene, const Materials& m) {
  const Vec3f center(0.25f, 2.85f, -0.9f);
  const int lamp = scene.add_node("orrery", -1, at(center));
  PhongSurface glow = matte({1.0f, 0.85f, 0.55f});
  glow.emission = {0.85f, 0.66f, 0.36f};
  scene.show("sun", Spheres{{Vec3f(0.0f), 0.15f}}, scene.add_material("lamp", glow), lamp);
  scene.show("rod", Cylinders{{{0.0f, 0.13f, 0.0f}, {0.0f, kHeight - center.y, 0.0f}, 0.015f}}, m.brass, lamp);

  struct Planet {
    float distance, radius, height;
    int turns;
    Vec3f color;
  };
  for (const Planet& p :
       {Planet{0.36f, 0.055f, 0.07f, 4, {0.75f, 0.35f, 0.12f}}, Planet{0.56f, 0.085f, 0.00f, -3, {0.10f, 0.35f, 0.70f}},
        Planet{0.80f, 0.075f, -0.07f, 2, {0.65f, 0.10f, 0.06f}}, Planet{1.06f, 0.115f, 0.04f, -1, {0.80f, 0.62f, 0.35f}}}) {
    const int orbit = scene.add_node("planet's orbit", lamp, at({0.0f, p.height, 0.0f}));
    scene.spin(orbit, kUp, p.turns, 0.3f * p.distance);
    scene.show("planet's arm", Cylinders{{Vec3f(0.0f), {p.distance, 0.0f, 0.0f}, 0.008f}}, m.brass, orbit);
    scene.show("planet", Spheres{{{p.distance, 0.0f, 0.0f}, p.radius}},
               scene.add_material("planet", glossy(p.color, 0.5f, 50.0f)), orbit);
  }
}

/// The radius of the ball's path is eight times the ball's radius, so the ball makes eight turns per round.
void add_ball(SceneBuilder& scene) {
  constexpr float kRadius = 0.14f, kDistance = 8.0f * kRadius;
  const int around = scene.add_node("ball's way", -1, at(kTable));
  scene.spin(around, kUp, -2, 0.15f);
  const int ball = scene.add_node("ball", around, at({kDistance, kRadius + 0.008f, 0.0f}));
  scene.spin(ball, kRight, 16);
  const Texture segments = paint("ball", 96, 8, [](Vec2f uv) {
    constexpr Vec3f kColors[] = {{0.75f, 0.05f, 0.04f}, {0.85f, 0.82f, 0.75f}, {0.05f, 0.18f, 0.55f},
                                 {0.85f, 0.82f, 0.75f}, {0.85f, 0.55f, 0.04f}, {0.85f, 0.82f, 0.75f}};
    return kColors[static_cast<int>(uv.x * 6.0f)];
  });
  scene.show("ball", uv_sphere(kRadius, 72, 36), textured(scene, "ball", segments, glossy(Vec3f(1.0f), 0.4f, 50.0f)), ball);
}

}  // namespace

Scene build_room() {
  SceneBuilder scene("room");
  const Materials m{scene.add_material("walnut", glossy({0.22f, 0.09f, 0.035f}, 0.35f, 40.0f, 0.05f)),
                    scene.add_material("brass", polished_metal({0.80f, 0.52f, 0.18f}, 0.18f)),
                    scene.add_material("ivory", matte({0.74f, 0.70f, 0.60f})),
                    scene.add_material("white", matte({0.90f, 0.88f, 0.82f})),
                    scene.add_material("ebony", glossy({0.03f, 0.025f, 0.02f}, 0.4f, 50.0f))};
  add_walls(scene, m);
  add_table(scene, m);
  add_mirror(scene, m);
  add_vase(scene, kTable + Vec3f(-0.42f, 0.80f, 0.12f), 0.34f,
           scene.add_material("blue glaze", glossy({0.03f, 0.12f, 0.42f}, 0.7f, 80.0f, 0.10f)));
  add_vase(scene, {1.78f, 0.0f, -0.3f}, 0.85f,
           scene.add_material("red glaze", glossy({0.50f, 0.07f, 0.03f}, 0.5f, 60.0f, 0.06f)));
  add_ornament(scene, m);
  add_globe(scene, m);
  add_clock(scene, m);
  add_orrery(scene, m);
  add_ball(scene);

  scene.add_light("evening sun", {-3.2f, 4.2f, 6.0f}, {0.72f, 0.66f, 0.58f});
  scene.add_light("lamp", {0.25f, 2.3f, -0.9f}, {0.42f, 0.33f, 0.22f});
  scene.set_background({0.40f, 0.27f, 0.18f}, {0.12f, 0.20f, 0.40f});
  constexpr float kPlaneHeight = 4.1f;
  const int display = scene.set_display({0.0f, 1.62f, -0.3f}, 0.0f, radians(7.0f), kPlaneHeight, 2.4f * kPlaneHeight);
  scene.swing(display, kUp, {.amplitude = radians(7.0f), .cycles = 1, .phase = 0.0f});
  return scene.take();
}

}  // namespace lippmann::builtin

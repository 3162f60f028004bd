#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lippmann/scene/timeline.hpp"
#include "scene/builtin/scenes.hpp"

namespace lippmann::builtin {
namespace {

struct PlacedSphere {
  Vec3f center;
  float radius;
};

std::vector<PlacedSphere> spheres_of(const Scene& scene, double time) {
  const ResolvedScene resolved = evaluate(scene, time);
  std::vector<PlacedSphere> placed;
  for (const Instance& instance : scene.instances)
    if (const Spheres* spheres = std::get_if<Spheres>(&scene.shapes[static_cast<std::size_t>(instance.shape)]))
      for (const Sphere& s : *spheres) placed.push_back({transform_point(resolved.of(instance.node), s.center), s.radius});
  return placed;
}

int find_node(const Scene& scene, std::string_view name) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    if (scene.nodes[i].name == name) return static_cast<int>(i);
  return -1;
}

TEST(SmallBalls, each_generation_has_nine_times_the_spheres) {
  std::map<int, int> count;
  for (const PlacedSphere& s : spheres_of(build_small_balls(), 0.0))
    ++count[static_cast<int>(std::lround(-std::log(s.radius) / std::log(3.0f)))];
  EXPECT_EQ(count, (std::map<int, int>{{0, 1}, {1, 9}, {2, 81}, {3, 729}, {4, 6561}}));
}

TEST(SmallBalls, first_generation_touches_its_parent) {
  const Scene scene = build_small_balls();
  for (const double time : {0.0, 3.7}) {
    int touching = 0;
    for (const PlacedSphere& s : spheres_of(scene, time))
      if (std::abs(s.radius - 1.0f / 3.0f) < 1e-5f) touching += std::abs(glm::length(s.center) - 4.0f / 3.0f) < 1e-4f ? 1 : 0;
    EXPECT_EQ(touching, 9);
  }
}

std::size_t shown_triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Instance& instance : scene.instances)
    if (const Mesh* mesh = std::get_if<Mesh>(&scene.shapes[static_cast<std::size_t>(instance.shape)]))
      count += mesh->triangles.size();
  return count;
}

TEST(Tree, shows_about_900000_triangles) {
  const Scene scene = build_tree();
  std::size_t stored = 0;
  for (const Shape& shape : scene.shapes)
    if (const Mesh* mesh = std::get_if<Mesh>(&shape)) stored += mesh->triangles.size();
  EXPECT_NEAR(static_cast<double>(shown_triangles(scene)), 9e5, 2e4);
  EXPECT_LT(stored, 60000u);
}

TEST(Room, has_about_70000_triangles) { EXPECT_NEAR(static_cast<double>(shown_triangles(build_room())), 7e4, 2e4); }

TEST(Room, ball_rolls_without_slipping) {
  // The point of the ball that touches the carpet is at rest. In a millisecond, this point moves by less than 5 % of
  // the motion of the ball's centre.
  const Scene scene = build_room();
  const int ball = find_node(scene, "ball");
  const double time = 3.0, step = 1e-3;
  const ResolvedScene before = evaluate(scene, time), after = evaluate(scene, time + step);
  const Vec3f center = before.of(ball).translation;
  const Vec3f foot = transform_point(inverse(before.of(ball)), {center.x, center.y - 0.14f, center.z});
  const float foot_moves = glm::length(transform_point(after.of(ball), foot) - transform_point(before.of(ball), foot));
  const float center_moves = glm::length(after.of(ball).translation - center);
  EXPECT_GT(center_moves, 1e-5f);
  EXPECT_LT(foot_moves, 0.05f * center_moves);
}

TEST(Primitives, shows_every_kind_of_finite_shape) {
  std::map<std::size_t, int> kinds;
  for (const Shape& shape : build_primitives().shapes) ++kinds[shape.index()];
  for (const Shape& kind : {Shape(Mesh{}), Shape(Spheres{}), Shape(Cylinders{}), Shape(Rings{}), Shape(Boxes{})})
    EXPECT_GE(kinds[kind.index()], 1) << kind.index();
}

float turned_about_z(const Scene& scene, int node, double from, double to) {
  const Vec3f a = evaluate(scene, from).of(node).linear[0], b = evaluate(scene, to).of(node).linear[0];
  return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

TEST(Gears, planetary_set_obeys_willis_equation) {
  const Scene scene = build_gears();
  const auto speed = [&](const char* name) { return turned_about_z(scene, find_node(scene, name), 2.0, 2.25); };
  const float sun = speed("sun"), ring = speed("ring"), carrier = speed("carrier"), planet = speed("planet");
  EXPECT_NEAR(sun - carrier, -36.0f / 12.0f * (ring - carrier), 1e-4f);
  EXPECT_NEAR(planet - carrier, 36.0f / 12.0f * (ring - carrier), 1e-4f);
  EXPECT_GT(std::abs(ring), 0.01f);
}

}  // namespace
}  // namespace lippmann::builtin

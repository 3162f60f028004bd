// Very distant parts are left out of the view, with a warning, because a view of everything would show nothing.
#include "stage/main_part.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lippmann/stage/fit_array.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;
using testing::Not;

ScenePiece cube(Vec3f at, float size = 1.0f) {
  return {{at - Vec3f(0.5f * size), at + Vec3f(0.5f * size)}, 6.0f * size * size, false};
}

bool holds(const Bounds3f& box, Vec3f p) {
  return glm::all(glm::lessThanEqual(box.lower, p)) && glm::all(glm::lessThanEqual(p, box.upper));
}

TEST(MainPart, nearby_pieces_stay_together) {
  EXPECT_FALSE(find_main_part({}));
  EXPECT_FALSE(find_main_part({cube(Vec3f(0))}));
  EXPECT_FALSE(find_main_part({cube(Vec3f(0)), cube({15, 0, 0})}));
  std::vector<ScenePiece> row;
  for (int i = 0; i < 40; ++i) row.push_back(cube({40.0f * static_cast<float>(i), 0, 0}));
  EXPECT_FALSE(find_main_part(row)) << "evenly scattered";
  EXPECT_FALSE(find_main_part({cube(Vec3f(0)), {{Vec3f(kInfinity), Vec3f(kInfinity)}, 0.0f, false}}));
}

TEST(MainPart, strays_on_any_side_are_left_out) {
  const std::vector<ScenePiece> main{cube({3, 0, 0}), cube({4, 1, 0}), cube({4, 0, -1})};
  const std::vector<Vec3f> strays{{5000, 0, 0}, {-900, 20, 0}, {0, 0, 1e6f}, {0, -800, 0}, {150, 0, 0}};
  for (std::size_t count = 1; count <= strays.size(); ++count) {
    std::vector<ScenePiece> pieces = main;
    for (std::size_t i = 0; i < count; ++i) pieces.push_back(cube(strays[i], 0.5f));
    const auto box = find_main_part(pieces);
    ASSERT_TRUE(box) << count;
    for (const ScenePiece& piece : main) EXPECT_TRUE(holds(*box, piece.bounds.center()));
    for (std::size_t i = 0; i < count; ++i) EXPECT_FALSE(holds(*box, strays[i])) << i << " of " << count;
  }
}

TEST(MainPart, the_side_with_more_surface_remains) {
  const auto box = find_main_part({cube(Vec3f(0)), cube({0.2f, 0, 0}), cube({1300, 0, 900}, 20.0f)});
  ASSERT_TRUE(box);
  EXPECT_TRUE(holds(*box, {1300, 0, 900}));
  EXPECT_FALSE(holds(*box, Vec3f(0)));
}

Mesh triangle_at(Vec3f at, float size) {
  Mesh mesh;
  mesh.positions = {at, at + Vec3f(size, 0, 0), at + Vec3f(0, size, 0)};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

void add(Scene& scene, const char* name, Shape shape) {
  Node node;
  Instance instance;
  instance.name = name;
  instance.node = static_cast<int>(scene.nodes.size());
  instance.shape = static_cast<int>(scene.shapes.size());
  scene.nodes.push_back(node);
  scene.shapes.push_back(std::move(shape));
  scene.instances.push_back(instance);
}

TEST(MainPart, a_stray_part_does_not_change_the_view) {
  Scene alone;
  add(alone, "box", Boxes{{Vec3f(-1), Vec3f(1)}});
  Scene with_stray = alone;
  add(with_stray, "lost", triangle_at({5000, 0, 0}, 0.3f));
  const FittedArray wanted = fit_array(alone), array = fit_array(with_stray);
  EXPECT_EQ(array.viewing_distance, wanted.viewing_distance);
  EXPECT_EQ(array.plane_height, wanted.plane_height);
  EXPECT_THAT(array.warning, HasSubstr("'lost'"));
  EXPECT_EQ(wanted.warning, "");
  EXPECT_EQ(array.is_subject, (std::vector<bool>{true, false}));
}

TEST(MainPart, a_stray_triangle_does_not_change_the_view) {
  Mesh mesh = triangle_at(Vec3f(0), 1.0f);
  Scene alone;
  add(alone, "mesh", mesh);
  mesh.positions.insert(mesh.positions.end(), {{700, 0, 0}, {700, 1, 0}, {700, 0, 0.5f}});
  mesh.triangles.push_back({3, 4, 5});
  Scene with_stray;
  add(with_stray, "mesh", mesh);
  EXPECT_NEAR(fit_array(with_stray).viewing_distance, fit_array(alone).viewing_distance, 1e-4f);
  EXPECT_THAT(fit_array(with_stray).warning, HasSubstr("parts of 'mesh'"));
}

TEST(MainPart, a_stray_vertex_does_not_change_the_view) {
  Mesh mesh = triangle_at(Vec3f(0), 1.0f);
  Scene alone;
  add(alone, "mesh", mesh);
  mesh.positions.push_back({1e5f, 0, 0});
  mesh.triangles.push_back({0, 2, 3});
  Scene with_stray;
  add(with_stray, "mesh", mesh);
  EXPECT_LT(fit_array(with_stray).viewing_distance, 5.0f * fit_array(alone).viewing_distance);
  EXPECT_THAT(fit_array(with_stray).warning, HasSubstr("'mesh'"));
}

TEST(MainPart, a_rod_is_whole) {
  Mesh thin;
  thin.positions = {{0, 0, 0}, {1e4f, 0, 0}, {0, 1, 0}, {1e4f, 1, 0}};
  thin.triangles = {{0, 1, 2}, {1, 3, 2}};
  Scene rod;
  add(rod, "rod", thin);
  EXPECT_GT(fit_array(rod).viewing_distance, 1e3f);
}

TEST(MainPart, a_stray_ball_does_not_change_the_view) {
  Scene alone, with_stray;
  add(alone, "balls", Spheres{{{0, 0, 0}, 1.0f}, {{2, 0, 0}, 1.0f}});
  add(with_stray, "balls", Spheres{{{0, 0, 0}, 1.0f}, {{2, 0, 0}, 1.0f}, {{0, 900, 0}, 1.0f}});
  EXPECT_LT(fit_array(with_stray).viewing_distance, 2.0f * fit_array(alone).viewing_distance);
  EXPECT_NE(fit_array(with_stray).warning, "");
}

TEST(MainPart, stray_splats_are_counted) {
  Splats splats;
  for (int i = 0; i < 200; ++i)
    splats.centers.emplace_back(0.1f * static_cast<float>(i % 6), 0.1f * static_cast<float>(i / 6 % 6),
                                0.02f * static_cast<float>(i / 36));
  splats.centers.emplace_back(1e5f, 0, 0);
  const std::size_t count = splats.centers.size();
  splats.rotations.assign(count, {1, 0, 0, 0});
  splats.deviations.assign(count, Vec3f(0.05f));
  splats.opacities.assign(count, 0.9f);
  splats.harmonics.assign(count, Vec3f(1));
  Scene scene;
  add(scene, "capture", splats);
  const FittedArray array = fit_array(scene);
  EXPECT_EQ(array.warning, "The view leaves out what lies far away from everything else: 1 splat of 'capture'");
  EXPECT_THAT(array.how, HasSubstr("Left out as far away: 1 splat of 'capture'."));
  std::get<Splats>(scene.shapes.front()).centers.back().x = 1.0f;
  EXPECT_EQ(fit_array(scene).warning, "");
}

TEST(MainPart, named_objects_are_never_stray) {
  Scene scene;
  add(scene, "box", Boxes{{Vec3f(-1), Vec3f(1)}});
  add(scene, "lost", triangle_at({5000, 0, 0}, 0.3f));
  for (std::size_t i = 0; i < 2; ++i) scene.nodes[i].name = scene.instances[i].name;
  ViewWish wish;
  wish.fit_to = "lost";
  const FittedArray array = fit_array(scene, 1.0f, wish);
  EXPECT_LT(array.viewing_distance, 2.0f);
  EXPECT_EQ(array.warning, "");
}

}  // namespace
}  // namespace lippmann

// Scenes that are far from the origin, for example in map coordinates.
#include "lippmann/scene/origin.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/fingerprint.hpp"
#include "scene/tachyon.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

/// A place so far from the origin that floats have a spacing of half a unit.
const Vec3d kPlace(4512345.125, 320.5, -5400000.25);

std::string text_of(Vec3d p) { return fmt::format("{} {} {}", p.x, p.y, p.z); }

class FarScene : public testing::Test {
 protected:
  Scene load(const std::string& name, const std::string& contents, std::vector<std::string>* warnings = nullptr) const {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << contents;
    Context context;
    if (warnings) context.warn = [warnings](std::string_view text) { warnings->emplace_back(text); };
    return load_scene(path.string(), {}, context);
  }

  test::TempDir folder_;
};

Vec3d in_file(const Scene& scene, Vec3f p) { return scene.origin + Vec3d(p); }

void expect_near(Vec3d a, Vec3d b, double tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance) << text_of(a) << " and " << text_of(b);
}

/// Coordinates below 16 have rounding errors of at most 2^-21, so points of two scenes differ by at most sqrt(3) * 2 *
/// 2^-21 = 1.7e-6.
constexpr double kOriginRounding = 2e-6;

const std::vector<Vec3d> kCorners{{0.1, 0.2, 0.3}, {1.1, 0.2, 0.3}, {0.1, 1.3, 0.3}, {0.7, 0.9, -0.4}};

std::string obj_at(Vec3d place) {
  std::string text;
  for (const Vec3d& corner : kCorners) text += "v " + text_of(place + corner) + "\n";
  return text + "f 1 2 3\nf 1 2 4\n";
}

/// Returns a file with one splat at place + kCorners[0]. The upward axis of the file is z if `z_up`, and -y otherwise.
std::string splat_at(Vec3d place, bool z_up) {
  const Vec3d at = place + kCorners[0], in_file = z_up ? Vec3d(at.x, -at.z, at.y) : Vec3d(at.x, -at.y, -at.z);
  return fmt::format(
      "ply\nformat ascii 1.0\n{}element vertex 1\nproperty double x\nproperty double y\nproperty double z\n"
      "property float scale_0\nproperty float opacity\nproperty float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n"
      "end_header\n{} -3 4 0 0 0\n",
      z_up ? "comment Vertical Axis: z\n" : "", text_of(in_file));
}

std::string ply_at(Vec3d place) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (const Vec3d& corner : kCorners) text += text_of(place + corner) + "\n";
  return text + "3 0 1 2\n3 0 1 3\n";
}

void expect_corners(const Scene& scene, Vec3d place) {
  const Mesh& mesh = std::get<Mesh>(scene.shapes.at(0));
  ASSERT_EQ(mesh.positions.size(), kCorners.size());
  for (std::size_t i = 0; i < kCorners.size(); ++i)
    expect_near(in_file(scene, mesh.positions[i]), place + kCorners[i], kOriginRounding);
}

TEST_F(FarScene, obj_keeps_the_digits_of_its_text) { expect_corners(load("a.obj", obj_at(kPlace)), kPlace); }

TEST_F(FarScene, ply_keeps_the_digits_of_its_numbers) { expect_corners(load("a.ply", ply_at(kPlace)), kPlace); }

TEST_F(FarScene, splats_keep_the_digits_of_their_numbers) {
  for (const bool z_up : {false, true}) {
    const Scene scene = load("a.ply", splat_at(kPlace, z_up));
    const Vec3f center = std::get<Splats>(scene.shapes.at(0)).centers.at(0);
    const Affine3f place = evaluate(scene, 0.0).of(scene.instances.at(0).node);
    expect_near(in_file(scene, transform_point(place, center)), kPlace + kCorners[0], kOriginRounding);
  }
}

TEST_F(FarScene, nff_keeps_precision) {
  const Vec3d eye = kPlace + Vec3d(0.1, 0.2, 5.3), lamp = kPlace + Vec3d(2.1, 3.2, 1.3);
  const Scene scene =
      load("a.nff", "v\nfrom " + text_of(eye) + "\nat " + text_of(kPlace) +
                        "\nup 0 1 0\nangle 40\nhither 1\nresolution 64 64\nl " + text_of(lamp) + "\nf 1 0 0 1 0 0 0 1\ns " +
                        text_of(kPlace + kCorners[0]) + " 0.25\np 3\n" + text_of(kPlace + kCorners[0]) + "\n" +
                        text_of(kPlace + kCorners[1]) + "\n" + text_of(kPlace + kCorners[2]) + "\n");
  const ResolvedScene rest = evaluate(scene, 0.0);
  expect_near(in_file(scene, rest.of(scene.cameras.at(0).node).translation), eye, kOriginRounding);
  expect_near(in_file(scene, rest.of(scene.lights.at(0).node).translation), lamp, kOriginRounding);
  for (const Shape& shape : scene.shapes) {
    if (const auto* spheres = std::get_if<Spheres>(&shape))
      expect_near(in_file(scene, spheres->at(0).center), kPlace + kCorners[0], kOriginRounding);
    if (const auto* mesh = std::get_if<Mesh>(&shape))
      expect_near(in_file(scene, mesh->positions.at(1)), kPlace + kCorners[1], kOriginRounding);
  }
}

std::string tachyon_at(Vec3d place) {
  const auto at = [&](double x, double y, double z) { return text_of(place + Vec3d(x, y, z)); };
  return "BEGIN_SCENE\nRESOLUTION 64 64\nCAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 4 CENTER " + at(0, 0, -5.5) +
         " VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA\nLIGHT CENTER " + at(1.1, 2.2, -3.3) + " RAD 0.1 COLOR 1 1 1\n" +
         "TEXDEF t AMBIENT 0.1 DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 1 0 0 TEXFUNC 0\n" + "SPHERE CENTER " +
         at(0.1, 0.2, 0.3) + " RAD 0.5 t\nFCYLINDER BASE " + at(0.4, 0, 0) + " APEX " + at(0.9, 0.1, 0) +
         " RAD 0.1 t\nBOX MIN " + at(-1.1, -0.2, 0) + " MAX " + at(-0.6, 0.3, 0.4) + " t\nTRI V0 " + at(0.1, 1, 0) + " V1 " +
         at(1.1, 1, 0) + " V2 " + at(0.1, 1.7, 0) + " t\nEND_SCENE\n";
}

TEST_F(FarScene, tachyon_is_the_same_scene_elsewhere) {
  const Scene near = load("near.dat", tachyon_at(Vec3d(0.0))), far = load("far.dat", tachyon_at(kPlace));
  EXPECT_EQ(near.origin, Vec3d(0.0));
  ASSERT_NE(far.origin, Vec3d(0.0));
  const Vec3d place(kPlace.x, kPlace.y, -kPlace.z);  // Tachyon's z is mirrored because its world is left-handed
  const ResolvedScene near_rest = evaluate(near, 0.0), far_rest = evaluate(far, 0.0);
  ASSERT_EQ(near.instances.size(), far.instances.size());
  for (std::size_t i = 0; i < near.instances.size(); ++i) {
    const Bounds3f a = finite_bounds(near, near.instances[i], near_rest), b = finite_bounds(far, far.instances[i], far_rest);
    expect_near(in_file(far, b.lower), place + Vec3d(a.lower), kOriginRounding);
    expect_near(in_file(far, b.upper), place + Vec3d(a.upper), kOriginRounding);
  }
  for (std::size_t i = 0; i < near.nodes.size(); ++i)
    expect_near(in_file(far, far_rest.world_from_node[i].translation), place + Vec3d(near_rest.world_from_node[i].translation),
                kOriginRounding);
}

TEST_F(FarScene, warnings_are_given_once) {
  std::vector<std::string> warnings;
  load("a.obj", obj_at(kPlace) + "curv 0 1 1 2\n", &warnings);
  EXPECT_EQ(warnings.size(), 1u);
}

TEST_F(FarScene, near_scenes_keep_their_origin) {
  for (const double away : {0.0, 10.0, 60.0}) EXPECT_EQ(load("a.obj", obj_at(Vec3d(away, 0, 0))).origin, Vec3d(0.0)) << away;
  // The diagonal of the corners' bounds is 1.66 units, and the limit 64 diagonals = 106 units.
  EXPECT_NE(load("a.obj", obj_at(Vec3d(120.0, 0, 0))).origin, Vec3d(0.0));
}

TEST_F(FarScene, origin_is_part_of_the_fingerprint) {
  EXPECT_NE(fingerprint(load("a.obj", obj_at(kPlace))), fingerprint(load("b.obj", obj_at(kPlace + Vec3d(1024.0, 0, 0)))));
}

Scene scene_on_a_map() {
  Scene scene;
  const Vec3f far(kPlace);
  scene.nodes.resize(5);
  scene.nodes[0].local = {Vec3f(0), glm::angleAxis(radians(90.0f), Vec3f(1, 0, 0)), Vec3f(0.5f)};
  scene.nodes[1].parent = 0;
  scene.nodes[1].local = {2.0f * Vec3f(far.x, far.z, -far.y), Quatf(1, 0, 0, 0), Vec3f(2)};
  scene.nodes[2].local.translation = far + Vec3f(0, 0, 8);
  scene.nodes[3].local.translation = far + Vec3f(4, 4, 4);
  scene.nodes[4].local.translation = far;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  scene.shapes = {mesh, Spheres{{Vec3f(far.x + 2, far.y, far.z), 0.5f}}};
  scene.materials.resize(1);
  scene.instances = {{"below", 0, 0, 1}, {"at", 0, 0, 4}, {"in the world", 1, 0, -1}};
  scene.cameras.resize(1), scene.cameras[0].node = 2;
  scene.lights.resize(2), scene.lights[0].node = 3;
  return scene;
}

TEST(Origin, everything_stands_where_it_stood) {
  const Scene before = scene_on_a_map();
  Scene after = before;
  move_near_origin(after);
  ASSERT_NE(after.origin, Vec3d(0.0));
  validate(after, "after");
  const ResolvedScene was = evaluate(before, 0.0), is = evaluate(after, 0.0);
  constexpr double kHalfUnit = 1.0;  // before the move, floats have a spacing of half a unit
  for (std::size_t i = 0; i < before.instances.size(); ++i) {
    const Bounds3f a = finite_bounds(before, before.instances[i], was), b = finite_bounds(after, after.instances[i], is);
    expect_near(in_file(after, b.lower), Vec3d(a.lower), kHalfUnit);
    EXPECT_LT(glm::length(b.center()), 20.0f) << before.instances[i].name;
  }
  expect_near(in_file(after, is.of(after.cameras[0].node).translation), Vec3d(was.of(2).translation), kOriginRounding);
  expect_near(in_file(after, is.of(after.lights[0].node).translation), Vec3d(was.of(3).translation), kOriginRounding);
  expect_near(in_file(after, is.of(after.lights[1].node).translation), Vec3d(0.0), 1.0);
}

TEST(Origin, meshes_below_nodes_are_not_rounded) {
  Scene scene = scene_on_a_map();
  move_near_origin(scene);
  const ResolvedScene rest = evaluate(scene, 0.0);
  const Bounds3f below = finite_bounds(scene, scene.instances[0], rest), at = finite_bounds(scene, scene.instances[1], rest);
  // The mesh at node 1 is scaled by 0.5 * 2 and rotated by 90 degrees about x, so its size of 1 x 1 is along x and z.
  expect_near(Vec3d(below.size()), Vec3d(1, 0, 1), kOriginRounding);
  expect_near(Vec3d(at.size()), Vec3d(1, 1, 0), kOriginRounding);
  expect_near(Vec3d(below.lower), Vec3d(at.lower), 1e-5);
}

TEST(Origin, animated_nodes_move_with_it) {
  Scene before = scene_on_a_map();
  NodeAnimation move, turn;
  move.node = 4;
  move.translation = {{0, 1}, {Vec3f(kPlace), Vec3f(kPlace) + Vec3f(8, 0, 0)}};
  turn.node = 1;
  turn.rotation = {{0, 1}, {Quatf(1, 0, 0, 0), glm::angleAxis(radians(180.0f), Vec3f(0, 1, 0))}};
  before.timeline.animations = {move, turn};
  Scene after = before;
  move_near_origin(after);
  for (const double time : {0.0, 0.5, 1.0}) {
    const ResolvedScene was = evaluate(before, time), is = evaluate(after, time);
    for (const int node : {1, 4}) {
      expect_near(in_file(after, is.of(node).translation), Vec3d(was.of(node).translation), 1.0);
      EXPECT_LT(glm::length(is.of(node).translation), 20.0f);
      for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(is.of(node).linear[c] - was.of(node).linear[c]), 1e-6f);
    }
  }
}

TEST(Origin, skinned_meshes_follow_their_joints) {
  Scene before = scene_on_a_map();
  Mesh skinned = std::get<Mesh>(before.shapes[0]);
  for (Vec3f& p : skinned.positions) p += Vec3f(kPlace);
  skinned.skin = {1, {0, 0, 1}, {1, 1, 1}};
  before.shapes.push_back(skinned);
  // Joint 0 is in map coordinates. Joint 1 is at the old origin and does not move.
  before.nodes.resize(6);
  before.skins = {{"", {4, 5}, {Affine3f{Mat3f(1.0f), -Vec3f(kPlace)}, Affine3f{}}}};
  before.instances.push_back({"skinned", 2, 0, 5});
  before.instances.back().skin = 0;
  Scene after = before;
  move_near_origin(after);
  const Bounds3f was = finite_bounds(before, before.instances[3], evaluate(before, 0.0));
  const Bounds3f is = finite_bounds(after, after.instances[3], evaluate(after, 0.0));
  expect_near(in_file(after, is.lower), Vec3d(was.lower), 1.0);
  EXPECT_LT(glm::length(is.center()), 20.0f);
}

TEST(Origin, shape_of_several_nodes_is_copied) {
  Scene scene = scene_on_a_map();
  scene.nodes.resize(6);
  scene.nodes[5].local.translation = {1, 0, 0};
  scene.instances.push_back({"same sphere at a node", 1, 0, 5});
  scene.instances.push_back({"same sphere in the world", 1, 0, -1});
  move_near_origin(scene);
  EXPECT_EQ(scene.shapes.size(), 3u);
  const ResolvedScene rest = evaluate(scene, 0.0);
  const auto middle = [&](std::size_t i) { return Vec3d(finite_bounds(scene, scene.instances[i], rest).center()); };
  expect_near(middle(3), middle(2) + Vec3d(1, 0, 0), kOriginRounding);
  expect_near(middle(4), middle(2), kOriginRounding);
}

void add_box(Scene& scene, float size, float x) {
  scene.nodes.emplace_back().local.translation = {x, 0, 0};
  scene.instances.push_back({"box", static_cast<int>(scene.shapes.size()), 0, static_cast<int>(scene.nodes.size()) - 1});
  scene.shapes.push_back(Boxes{{Vec3f(-0.5f * size), Vec3f(0.5f * size)}});
  scene.materials.resize(1);
}

TEST(Origin, larger_of_two_parts_decides) {
  Scene building_and_marker, ground_and_car;
  add_box(building_and_marker, 20.0f, 4000.0f), add_box(building_and_marker, 1.0f, 0.0f);
  add_box(ground_and_car, 20.0f, 0.0f), add_box(ground_and_car, 1.0f, 4000.0f);
  const std::optional<Vec3d> origin = distant_origin(building_and_marker);
  ASSERT_TRUE(origin);
  EXPECT_LE(glm::length(*origin - Vec3d(4000, 0, 0)), 20.0);
  EXPECT_FALSE(distant_origin(ground_and_car));
  move_near_origin(building_and_marker);
  EXPECT_FALSE(distant_origin(building_and_marker));
  const ResolvedScene rest = evaluate(building_and_marker, 0.0);
  for (const auto& [instance, x] : {std::pair(0, 4000.0), std::pair(1, 0.0)}) {
    const Bounds3f bounds = finite_bounds(building_and_marker, building_and_marker.instances[std::size_t(instance)], rest);
    expect_near(in_file(building_and_marker, bounds.center()), Vec3d(x, 0, 0), 1e-3);
  }
}

TEST(Origin, small_things_around_the_origin_keep_it) {
  Scene scene;
  for (const float x : {-1.0f, 1.0f}) add_box(scene, 0.001f, x);
  EXPECT_FALSE(distant_origin(scene));
}

TEST(Origin, near_scenes_stay_as_they_are) {
  for (const char* name : {"teapot", "gears", "primitives"}) {
    const Scene before = load_scene(name, {}, Context{});
    Scene after = before;
    move_near_origin(after);
    EXPECT_EQ(fingerprint(after), fingerprint(before)) << name;
  }
}

}  // namespace
}  // namespace lippmann

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using test::Picture;
using test::single_view;
using test::SmallScene;
using test::square;
using test::trace;

constexpr int kPosedSize = 32;

SmallScene deforming() {
  SmallScene s;
  const int red = s.material(test::glowing({1, 0, 0})), green = s.material(test::glowing({0, 1, 0}));
  Mesh skinned = square(1, 1), growing = square(0.5f, 0);
  skinned.skin = {1, {0, 0, 0, 0}, {1, 1, 1, 1}};
  const int joint = s.moving_node({-1, 0, 0}, {1, 0, 0}), elsewhere = s.node({Mat3f(1.0f), {50, 50, 50}});
  s.scene.skins = {{"", {joint}, {Affine3f{}}}};
  s.scene.instances[static_cast<std::size_t>(s.add(skinned, red, elsewhere))].skin = 0;
  growing.targets.resize(1);
  for (const Vec3f& p : growing.positions) growing.targets[0].positions.push_back(Vec3f(p.x, p.y, 0));
  const int node = s.moving_node({0, 0, 0}, {0, 0, 0});
  s.scene.nodes[static_cast<std::size_t>(node)].morph_weights = {0.0f};
  s.scene.timeline.animations.back().morph_weights = {{0.0, 1.0}, {0.0f, 1.0f}, Interpolation::kLinear};
  s.add(growing, green, node);
  s.scene.timeline.frames_per_second = 10.0;
  s.scene.timeline.frame_count = 10;
  return s;
}

TEST(PosedMesh, follows_joints_and_weights) {
  const Scene scene = deforming().scene;
  const Picture before = trace(scene, single_view(kPosedSize)), after = trace(scene, single_view(kPosedSize), {}, 1, 1.0);
  // The picture is 4 wide with 32 pixels: pixel 8 is at x = -0.94, pixel 23 at x = 0.94, and row 22 at y = -0.81.
  EXPECT_EQ(before.at(8, 16), Vec3f(1, 0, 0));
  EXPECT_EQ(before.at(23, 16), Vec3f(0, 0, 0));
  EXPECT_EQ(after.at(8, 16), Vec3f(0, 1, 0));
  EXPECT_EQ(after.at(23, 16), Vec3f(1, 0, 0));
  EXPECT_EQ(before.at(18, 22), Vec3f(0, 0, 0)) << "it has not grown yet";
  EXPECT_EQ(after.at(12, 22), Vec3f(0, 1, 0)) << "grown";
}

TEST(PosedMesh, picture_does_not_depend_on_earlier_frames) {
  const Scene scene = deforming().scene;
  const ThreadPool pool(2);
  const Context context;
  DeviceScene device(scene, pool);
  for (const double time : {0.9, 0.2, 0.5}) {
    device.update(evaluate(scene, time), pool);
    Image film;
    trace_frame({device, single_view(kPosedSize), {}}, {}, {pool, context}, {film});
    EXPECT_EQ(film.data, trace(scene, single_view(kPosedSize), {}, 1, time).film.data);
  }
}

TEST(PosedMesh, static_meshes_are_posed) {
  SmallScene s;
  Mesh mesh = square(1, 0);
  mesh.skin = {1, {0, 0, 0, 0}, {1, 1, 1, 1}};
  s.scene.skins = {{"", {s.node({Mat3f(1.0f), {1, 0, 0}})}, {Affine3f{}}}};
  s.scene.instances[static_cast<std::size_t>(s.add(mesh, s.material(test::glowing({1, 0, 0}))))].skin = 0;
  const Picture p = trace(s.scene, single_view(kPosedSize));
  EXPECT_EQ(p.at(4, 16), Vec3f(0, 0, 0));
  EXPECT_EQ(p.at(28, 16), Vec3f(1, 0, 0));
}

TEST(PosedMesh, mirroring_keeps_the_facing) {
  SmallScene s;
  Mesh mesh = square(1, 0);
  mesh.normals.assign(4, Vec3f(0, 0, 1));
  mesh.targets.resize(1);
  const int node = s.node({Mat3f(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3f(0.0f)});
  s.scene.nodes[0].morph_weights = {0.0f};
  s.add(mesh, s.material(test::matte(Vec3f(1.0f))), node);
  const Picture p = trace(s.scene, single_view(kPosedSize));
  EXPECT_EQ(p.aovs[Aov::kNormal].data[3 * (16 * kPosedSize + 16) + 2], 1.0f);
}

TEST(PosedMesh, textures_follow_its_coordinates) {
  SmallScene s;
  Texture stripes;
  stripes.width = 4, stripes.height = 1, stripes.srgb = false;
  for (const int grey : {0, 0, 255, 255})
    for (int c = 0; c < 4; ++c) stripes.rgba.push_back(static_cast<std::uint8_t>(c == 3 ? 255 : grey));
  s.scene.textures = {stripes};
  PhongSurface glow = test::glowing(Vec3f(1.0f));
  glow.texture = 0;
  Mesh mesh = square(1, 0);
  mesh.skin = {1, {0, 0, 0, 0}, {1, 1, 1, 1}};
  s.scene.skins = {{"", {s.moving_node({0, 0, 0}, {1, 0, 0})}, {Affine3f{}}}};
  s.scene.instances[static_cast<std::size_t>(s.add(mesh, s.material(glow)))].skin = 0;
  const Picture p = trace(s.scene, single_view(kPosedSize), {}, 1, 1.0);
  EXPECT_EQ(p.at(20, 16), Vec3f(0.0f));  // x = 0.56, in the left half of a square from 0 to 2
  EXPECT_EQ(p.at(28, 16), Vec3f(1.0f));  // x = 1.56, in its right half
}

}  // namespace
}  // namespace lippmann

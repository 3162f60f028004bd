// Meshes that cameras do not see, or that cast no shadow. The camera at (0, 0, 10) sees the square from -2 to 2 in x and y at z
// = 0.
#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

const Integrator kEitherLight[] = {Integrator::kWhitted, Integrator::kPath};
constexpr Vec3f kRed{1, 0, 0}, kBlue{0, 0, 0.25f};

Picture seen(const SmallScene& s, Integrator integrator, int spp = 1) {
  TraceParams params;
  params.spp = spp;
  return trace(s.scene, single_view(32), params, 2, 0.0, {}, integrator);
}

/// A blue wall at z = -1 behind a hidden red square at z = 0. The square belongs to node `moving`, or to none (-1).
SmallScene hidden_before_wall(int moving = -1) {
  SmallScene s;
  s.scene.max_depth = 4;
  if (moving >= 0) s.moving_node({0, 0, 0}, {0, 0, 0.1f});
  s.add(square(3, -1), s.material(glowing(kBlue)));
  const int hidden = s.add(square(1, 0), s.material(glowing(kRed)), moving);
  s.scene.instances[static_cast<std::size_t>(hidden)].hidden_from_cameras = true;
  return s;
}

TEST(Hidden, cameras_look_through_static_and_moving_meshes) {
  for (const int node : {-1, 0})
    for (const Integrator integrator : kEitherLight) {
      const Picture p = seen(hidden_before_wall(node), integrator);
      expect_color(p.at(16, 16), kBlue);
      EXPECT_NEAR(*p.aovs[Aov::kDepth].pixel(16, 16), -1.0f, 1e-5f);
    }
}

TEST(Hidden, cameras_look_through_instances_and_deforming_meshes) {
  SmallScene s = hidden_before_wall();
  Mesh morphing = square(1, 1);
  morphing.targets.resize(1);
  morphing.targets[0].positions.assign(morphing.positions.size(), Vec3f(0, 0, 0.5f));
  const int node = s.moving_node({0, 0, 0}, {0, 0, 0.1f});
  s.scene.nodes[static_cast<std::size_t>(node)].morph_weights = {1.0f};
  const int instance = s.add(morphing, s.material(glowing(kRed)), node);
  for (const Integrator integrator : kEitherLight) expect_color(seen(s, integrator).at(16, 16), kRed);
  s.scene.instances[static_cast<std::size_t>(instance)].hidden_from_cameras = true;
  for (const Integrator integrator : kEitherLight) expect_color(seen(s, integrator).at(16, 16), kBlue);
}

TEST(Hidden, hidden_meshes_stay_hidden_behind_holes) {
  SmallScene s = hidden_before_wall();
  MetallicRoughness veil;
  veil.base_color = Vec4f(0, 0, 0, 0.5f), veil.blend = true, veil.unlit = true;
  s.add(square(1, 1), s.material(veil));
  expect_color(seen(s, Integrator::kWhitted).at(16, 16), 0.5f * kBlue);
  const Vec3f path = seen(s, Integrator::kPath, 256).at(16, 16);
  EXPECT_EQ(path.x, 0.0f);
  EXPECT_NEAR(path.z, 0.125f, 0.025f);  // 3.2 standard deviations for 256 samples
}

TEST(Hidden, mirrors_and_panes_show_hidden_meshes) {
  for (const Integrator integrator : kEitherLight) {
    SmallScene s;
    s.scene.max_depth = 4;
    s.add(square(1, 0), s.material(mirror(1.0f)));
    const int behind = s.add(square(10, 20), s.material(glowing(kRed)));
    s.scene.instances[static_cast<std::size_t>(behind)].hidden_from_cameras = true;
    expect_color(seen(s, integrator).at(16, 16), kRed);
  }
  SmallScene s = hidden_before_wall();
  PhongSurface glass = matte(Vec3f(0.0f));
  glass.opacity = 0.0f;
  s.add(square(1, 1), s.material(glass));
  for (const Integrator integrator : kEitherLight) EXPECT_GT(seen(s, integrator).at(16, 16).x, 0.9f);
}

/// A matte floor at z = -1, a lamp at z = 5, and between them a square that is hidden from cameras.
SmallScene shaded_floor(bool casts_no_shadow) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.add(square(3, -1), s.material(matte(Vec3f(1.0f))));
  Instance& roof = s.scene.instances[static_cast<std::size_t>(s.add(square(1, 2), s.material(matte(Vec3f(0.0f)))))];
  roof.hidden_from_cameras = true;
  roof.casts_no_shadow = casts_no_shadow;
  s.point_light({0, 0, 5});
  return s;
}

TEST(Hidden, shadows_follow_their_own_flag) {
  for (const Integrator integrator : kEitherLight) {
    expect_color(seen(shaded_floor(false), integrator).at(16, 16), Vec3f(0.0f));
    const float lit = seen(shaded_floor(true), integrator).at(16, 16).x;
    SmallScene open = shaded_floor(true);
    open.scene.instances.pop_back();
    EXPECT_GT(lit, 0.0f);
    EXPECT_EQ(lit, seen(open, integrator).at(16, 16).x);
  }
}

TEST(Hidden, hidden_lamps_give_light) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.add(square(3, -1), s.material(matte(Vec3f(1.0f))));
  const int lamp = add_lamp_facing_down(s, 0.5f, 2, Vec3f(2.0f));
  const float floor = seen(s, Integrator::kPath, 256).at(4, 16).x;
  EXPECT_GT(floor, 0.01f);
  Instance& instance = s.scene.instances[static_cast<std::size_t>(lamp)];
  instance.hidden_from_cameras = instance.casts_no_shadow = true;
  EXPECT_EQ(seen(s, Integrator::kPath, 256).at(4, 16).x, floor);
}

}  // namespace
}  // namespace lippmann

#include "scene/builtin/scene_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/scene/timeline.hpp"
#include "support/near.hpp"

namespace lippmann::builtin {
namespace {

Vec3f moved(const Scene& scene, double time, Vec3f p) { return transform_point(evaluate(scene, time).world_from_node[0], p); }

using test::expect_near;

TEST(SceneBuilder, spin_is_uniform_and_comes_back) {
  for (const int turns : {1, 3, -2}) {
    SceneBuilder builder("s");
    builder.spin(builder.add_node("n", -1, at({1, 2, 3})), {0, 1, 0}, turns, 0.1f);
    const Scene scene = builder.take();
    for (const double share : {0.0, 0.07, 0.25, 0.61, 1.0}) {
      const double angle = 2.0 * M_PI * (turns * share + 0.1);
      const Vec3f expected(1.0 + std::cos(angle), 2.0, 3.0 - std::sin(angle));
      expect_near(moved(scene, share * kLoopSeconds, {1, 0, 0}), expected, 1e-5f);
    }
  }
}

TEST(SceneBuilder, swing_follows_the_sine) {
  SceneBuilder builder("s");
  builder.swing(builder.add_node("n", -1), {0, 1, 0}, {.amplitude = 0.5f, .cycles = 2, .phase = 0.3f});
  const Scene scene = builder.take();
  for (const double share : {0.0, 0.01, 0.13, 0.4, 0.77, 1.0}) {
    const double angle = 0.5 * std::sin(2.0 * M_PI * (2.0 * share + 0.3));
    // Between 16 keys per cycle, a cubic Hermite spline deviates from a sine of amplitude A = 0.5 by at most A * (2 pi
    // / 16)^4 / 384 = 6e-5 * A.
    expect_near(moved(scene, share * kLoopSeconds, {1, 0, 0}), Vec3f(std::cos(angle), 0.0, -std::sin(angle)), 4e-5f);
  }
}

TEST(SceneBuilder, bob_follows_the_sine) {
  SceneBuilder builder("s");
  builder.bob(builder.add_node("n", -1, at({0, 5, 0})), {0, 1, 0}, {.amplitude = 2.0f, .cycles = 3, .phase = 0.0f});
  const Scene scene = builder.take();
  for (const double share : {0.0, 0.03, 0.2, 0.9, 1.0})
    expect_near(moved(scene, share * kLoopSeconds, {0, 0, 0}), Vec3f(0.0, 5.0 + 2.0 * std::sin(6.0 * M_PI * share), 0.0),
                2e-4f);
}

TEST(SceneBuilder, camera_sees_exactly_the_array) {
  SceneBuilder builder("s");
  builder.set_display({1, 2, 3}, radians(30.0f), radians(20.0f), 4.0f, 10.0f);
  const Scene scene = builder.take();
  const ResolvedScene resolved = evaluate(scene, 0.0);
  const Affine3f world_from_display = resolved.of(scene.display->node), world_from_camera = resolved.of(scene.cameras[0].node);
  // Seen from the camera, the top edge of the display is half of the field of view above the axis.
  const Vec3f top = transform_point(inverse(world_from_camera), transform_point(world_from_display, {0, 2, 0}));
  EXPECT_NEAR(std::atan2(top.y, -top.z), 0.5f * scene.cameras[0].vertical_fov, 1e-6f);
  EXPECT_NEAR(top.x, 0.0f, 1e-5f);
  // A positive yaw puts the viewer to the right, a positive pitch above.
  const Vec3f viewer = world_from_camera.translation - Vec3f(1, 2, 3);
  EXPECT_NEAR(viewer.x, 10.0f * std::cos(radians(20.0f)) * std::sin(radians(30.0f)), 1e-4f);
  EXPECT_NEAR(viewer.y, 10.0f * std::sin(radians(20.0f)), 1e-4f);
}

}  // namespace
}  // namespace lippmann::builtin

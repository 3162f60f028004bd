#include "bench/hostile_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "job/placed_job.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann::bench {
namespace {

Scene scene_named(const std::string& name) {
  const auto& all = hostile_scenes();
  return std::find_if(all.begin(), all.end(), [&](const HostileScene& scene) { return scene.name == name; })->build();
}

/// Returns the longest distance that a shape or light moves since the previous frame, relative to the height of the
/// display plane. The distance is measured at points beside the shapes too, so that rotations count.
float largest_step(const Scene& scene, int frame) {
  const ResolvedScene before = evaluate(scene, scene.timeline.time(frame - 1)),
                      after = evaluate(scene, scene.timeline.time(frame));
  const float height = scene.display->plane_height, reach = height / 6.0f;
  const Affine3f array_moved = after.of(scene.display->node) * inverse(before.of(scene.display->node));
  float largest = 0.0f;
  for (const Instance& instance : scene.instances)
    for (const Vec3f& offset : {Vec3f(0.0f), Vec3f(reach, 0.0f, 0.0f), Vec3f(0.0f, reach, 0.0f), Vec3f(0.0f, 0.0f, reach)}) {
      std::vector<int> nodes{instance.node};
      if (instance.skin >= 0) nodes = scene.skins[static_cast<std::size_t>(instance.skin)].joints;
      for (const int node : nodes) {
        const Vec3f kept = transform_point(array_moved, transform_point(before.of(node), offset));
        largest = std::max(largest, glm::length(transform_point(after.of(node), offset) - kept));
      }
    }
  for (const Light& light : scene.lights)
    largest = std::max(largest, glm::length(after.of(light.node).translation - before.of(light.node).translation));
  return largest / height;
}

TEST(HostileScenes, have_unique_names_and_descriptions) {
  std::set<std::string> names;
  for (const HostileScene& scene : hostile_scenes()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_FALSE(scene.difficulty.empty()) << scene.name;
    EXPECT_EQ(scene.difficulty.find('\n'), std::string::npos) << scene.name;
  }
}

TEST(HostileScenes, pass_validation) {
  for (const HostileScene& scene : hostile_scenes()) EXPECT_NO_THROW(validate(scene.build(), scene.name)) << scene.name;
}

TEST(HostileScenes, have_the_requested_optics) {
  for (const HostileScene& hostile : hostile_scenes()) {
    const Scene scene = hostile.build();
    EXPECT_NO_THROW(validate(place(ResolvedJob(hostile.params), scene).placed.optics)) << hostile.name;
    EXPECT_EQ(hostile.params.sampling.integrator, Integrator::kPath) << hostile.name;
  }
}

TEST(HostileScenes, move_in_every_frame) {
  for (const HostileScene& hostile : hostile_scenes()) {
    const Scene scene = hostile.build();
    EXPECT_EQ(scene.timeline.frames_per_second, 25.0) << hostile.name;
    for (int frame = 1; frame < hostile.frames; ++frame) {
      // at least one pixel of a picture with 120 rows; for the scene "thin", a fifth of a pixel
      const float least = hostile.name == "thin" ? 0.2f / 120.0f : 1.0f / 120.0f;
      EXPECT_GT(largest_step(scene, frame), least) << hostile.name << ", frame " << frame;
    }
  }
}

TEST(HostileScenes, in_other_units_are_scaled) {
  const Scene scene = scene_named("bar-lamp"), small = scene_named("millimetres");
  const Bounds3f bounds = finite_bounds(scene, evaluate(scene, 0.2)), small_bounds = finite_bounds(small, evaluate(small, 0.2));
  EXPECT_NEAR(glm::length(small_bounds.size()), 1e-3f * glm::length(bounds.size()), 1e-6f);
  EXPECT_FLOAT_EQ(small.display->plane_height, 1e-3f * scene.display->plane_height);
}

}  // namespace
}  // namespace lippmann::bench

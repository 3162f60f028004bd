#include "reuse/tracing_costs.hpp"

#include <gtest/gtest.h>

#include "reuse/patches.hpp"

namespace lippmann {
namespace {

Scene spheres() {
  Scene scene;
  scene.shapes.push_back(Spheres(8, Sphere{}));
  scene.instances = {{"", 0, -1, -1}, {"", 0, -1, -1}};
  return scene;
}

TEST(TracingCosts, rays_cost_by_the_fourth_root_of_all_primitives) {
  EXPECT_NEAR(seconds_per_ray(spheres()), 21e-9, 1e-15);  // (5 + 8 * 16^(1/4)) ns
}

TEST(TracingCosts, prediction_cost_is_relative_to_tracing) {
  RayCounts rays;
  rays.primary = 1000, rays.shadow = 500, rays.reflection = 500;
  // Tracing 2000 rays takes 2000 * 21 ns = 42 us, predicting 420 pixels takes 420 * 50 ns = 21 us.
  EXPECT_NEAR(prediction_cost(spheres(), rays, 420), 0.5, 1e-12);
}

TEST(TracingCosts, partial_frames_cost_more_per_ray) {
  EXPECT_EQ(partial_tracing_cost(0.0), 0.0);
  EXPECT_NEAR(partial_tracing_cost(0.25), 0.45, 1e-12);
  EXPECT_NEAR(partial_tracing_cost(1.0), 1.1, 1e-12);
}

TEST(TracingCosts, patches_cost_by_the_rays_of_their_blocks) {
  Optics optics;
  optics.panel = {64, 16, 1.0f};
  optics.model = SingleView{100.0f, {0.0f, 0.0f}};
  const Patches patches(optics, RayOrder::kRows);
  ASSERT_EQ(patches.count(), 64u);  // patches of 16 pixels; 16 patches form a block
  const std::vector<float> costs = patches.costs(std::vector<std::uint32_t>{100, 200, 300, 200});
  for (std::size_t p = 0; p < costs.size(); ++p) {
    constexpr float kExpected[] = {0.5f, 1.0f, 1.5f, 1.0f};
    EXPECT_FLOAT_EQ(costs[p], kExpected[p / 16]) << p;
  }
}

}  // namespace
}  // namespace lippmann

// What a history's first frame finds out, by luck of the patches that it is measured on or not.
#include "radiance/plan_search.hpp"

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

/// A matt box that is open towards the viewer, with a lamp below its lid: sharing light is about as good there as it has to be.
SmallScene open_box() {
  SmallScene s;
  s.scene.max_depth = 6;
  const int white = s.material(matte(Vec3f(0.7f))), red = s.material(matte({0.6f, 0.1f, 0.1f}));
  const auto wall = [&](Vec3f a, Vec3f b, Vec3f c, Vec3f d, int material) {
    Mesh m;
    m.positions = {a, b, c, d};
    m.triangles = {{0, 1, 2}, {0, 2, 3}};
    s.add(m, material);
  };
  wall({-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}, white);
  wall({-2, -2, 2}, {2, -2, 2}, {2, -2, -2}, {-2, -2, -2}, white);
  wall({-2, 2, -2}, {2, 2, -2}, {2, 2, 2}, {-2, 2, 2}, white);
  wall({-2, -2, 2}, {-2, -2, -2}, {-2, 2, -2}, {-2, 2, 2}, red);
  wall({2, -2, -2}, {2, -2, 2}, {2, 2, 2}, {2, 2, -2}, red);
  s.point_light({0.0f, 1.5f, 0.0f}, Vec3f(0.5f));
  s.add(Boxes{{{-1.0f, -2.0f, -1.0f}, {0.0f, -0.5f, 0.0f}}}, white);
  return s;
}

TEST(PlanSearch, finds_a_plan_that_shares_light_whatever_the_seed) {
  const SmallScene s = open_box();
  const Optics optics = single_view(96);
  const ThreadPool pool(2);
  const Context context;
  DeviceScene device(s.scene, pool, Integrator::kPath);
  const ResolvedScene resolved = evaluate(s.scene, 0.0);
  device.update(resolved, pool);
  SurfacePlaces places(device.shaded());
  places.update(resolved);
  constexpr int kSeeds = 12;
  int sharing = 0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    TraceParams params;
    params.spp = 64, params.max_depth = 6, params.seed = seed;
    CacheHistory cells;
    const Shot shot{device, optics, {}};
    const Workers workers{pool, context};
    FrameCache cache(shot, places, params, workers, cells);
    const std::optional<GatherPlan> plan = PlanSearch(shot, params, {.frames = 16}, workers, cache).find();
    sharing += plan && plan->mix.samples == 0;
  }
  EXPECT_GE(sharing, 9);  // of a single look at each setup, four: the others mixed in a fifth to a half of the paths
}

}  // namespace
}  // namespace lippmann

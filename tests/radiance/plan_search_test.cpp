// What a history's first frame finds out, by luck of the patches that it is measured on or not.
#include "radiance/plan_search.hpp"

#include <gtest/gtest.h>

#include "radiance/cornell_box.hpp"

namespace lippmann {
namespace {

using namespace test;

/// Sharing light is about as good in this box, at this size, as it has to be.
TEST(PlanSearch, finds_a_plan_that_shares_light_whatever_the_seed) {
  const SmallScene s = cornell_box();
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
  EXPECT_GE(sharing, 10);  // with one look at each setup, six: the others mixed in a sixth to two fifths of the paths
}

}  // namespace
}  // namespace lippmann

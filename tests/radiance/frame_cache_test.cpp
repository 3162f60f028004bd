// Where updates of the cache may end their paths in it.
#include "radiance/frame_cache.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "radiance/cornell_box.hpp"

namespace lippmann {
namespace {

using namespace test;

/// Rays after the first surface, for each ray from the lens array.
double bounces(const RayCounts& now, const RayCounts& before = {}) {
  return static_cast<double>(now.indirect - before.indirect) / static_cast<double>(now.primary - before.primary);
}

// In a box of shining walls paths have up to six rays after the first surface, and those that end in the cache one.
TEST(FrameCache, paths_end_in_light_that_is_known_but_not_in_later_frames_nor_where_light_is_clamped) {
  const SmallScene s = shining_box(6);
  const ThreadPool pool(1);
  const Context context;
  const Optics optics = single_view(64);
  DeviceScene device(s.scene, pool, Integrator::kPath);
  SurfacePlaces places(device.shaded());
  const ResolvedScene resolved = evaluate(s.scene, 0.0);
  device.update(resolved, pool);
  places.update(resolved);
  std::vector<double> bounces_of_later;
  for (const float clamp : {0.0f, 1e6f}) {
    TraceParams params;
    params.max_depth = s.scene.max_depth, params.clamp_indirect = clamp;
    CacheHistory history;
    FrameCache first({device, optics, {}}, places, params, {pool, context}, history);
    const float cell = first.fitting_cell();
    first.set_up({.rounds = 4}, cell);
    const RayCounts at_first = first.counts();
    first.set_up({.rounds = 8}, cell);
    const RayCounts then = first.counts();
    const double whole = bounces(at_first), more = bounces(then, at_first);
    EXPECT_GT(whole, 1.5);
    if (clamp > 0.0f)
      EXPECT_GT(more, 0.8 * whole);
    else
      EXPECT_LT(more, 0.8 * whole);
    FrameCache later({device, optics, {}}, places, params, {pool, context}, history);
    later.go_on({});
    bounces_of_later.push_back(bounces(later.counts()));
  }
  EXPECT_EQ(bounces_of_later[0], bounces_of_later[1]);
}

}  // namespace
}  // namespace lippmann

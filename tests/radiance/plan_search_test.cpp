// What a history's first frame finds out, by luck of the patches that it is measured on or not.
#include "radiance/plan_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "radiance/cornell_box.hpp"

namespace lippmann {
namespace {

using namespace test;

/// What is found for a box with so many paths a pixel.
class BoxSearch {
 public:
  BoxSearch(const SmallScene& s, int spp) : spp_(spp), device_(s.scene, pool_, Integrator::kPath), places_(device_.shaded()) {
    const ResolvedScene resolved = evaluate(s.scene, 0.0);
    device_.update(resolved, pool_);
    places_.update(resolved);
  }

  std::optional<GatherPlan> find(std::uint32_t seed, int frames) const {
    TraceParams params;
    params.spp = spp_, params.max_depth = 6, params.seed = seed;
    CacheHistory cells;
    const Shot shot{device_, optics_, {}};
    const Workers workers{pool_, context_};
    FrameCache cache(shot, places_, params, workers, cells);
    return PlanSearch(shot, params, {.frames = frames}, workers, cache).find();
  }

 private:
  int spp_;
  const Optics optics_ = single_view(96);
  const ThreadPool pool_{2};
  const Context context_;
  DeviceScene device_;
  SurfacePlaces places_;
};

/// Sharing light is about as good in this box, at this size, as it has to be.
TEST(PlanSearch, finds_a_plan_that_shares_light_whatever_the_seed) {
  const SmallScene s = cornell_box();
  const BoxSearch search(s, 64);
  constexpr int kSeeds = 12;
  int sharing = 0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const std::optional<GatherPlan> plan = search.find(seed, 16);
    sharing += plan && plan->mix.samples == 0;
  }
  EXPECT_GE(sharing, 10);  // with one look at each setup, six: the others mixed in a sixth to two fifths of the paths
}

// Of eight paths in a white box, means err by so much that shared light may, too. With the first good setup three of these
// seeds have 2.2 to 2.4 codes.
TEST(PlanSearch, updates_cells_further_where_stains_of_over_two_codes_would_be_seen) {
  SmallScene s = cornell_box();
  for (Material& material : s.scene.materials) material.surface = matte(Vec3f(0.9f));
  s.scene.lights.clear();
  s.point_light({0.0f, 1.9f, 0.0f}, Vec3f(0.4f));
  const BoxSearch search(s, 8);
  int sharing = 0;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const std::optional<GatherPlan> plan = search.find(seed, 16);
    if (!plan || plan->mix.samples > 0) continue;
    EXPECT_LE(255.0f * std::sqrt(plan->expected.blocks), 2.0f) << seed;
    ++sharing;
  }
  EXPECT_GE(sharing, 4);
}

}  // namespace
}  // namespace lippmann

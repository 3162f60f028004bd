// What is measured of the errors of gathered frames.
#include "radiance/gather_error.hpp"

#include <gtest/gtest.h>

#include "lippmann/image/encode.hpp"
#include "radiance/update_frame.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

/// A matt floor and wall below a sky of `light`, whose soft light was fed 64 rounds.
class SkyScene {
 public:
  explicit SkyScene(float light)
      : s_(scene_below(light)), device_(s_.scene, pool_, Integrator::kPath), places_(device_.shaded()) {
    const ResolvedScene resolved = evaluate(s_.scene, 0.0);
    device_.update(resolved, pool_);
    places_.update(resolved);
    params_.max_depth = s_.scene.max_depth, params_.spp = 64;
    const CacheUpdater updater({device_, optics_, {}}, params_);
    for (int round = 0; round < 64; ++round) updater.update({cells_, cache_, pool_, context_}, round);
    cache_.resolve(pool_);
  }

  GatherMeasure measure(std::uint32_t frame = 0, const MeasuredPlaces& places = kPlanning) const {
    TraceParams params = params_;
    params.frame = frame;
    return {{device_, optics_, world_}, params, ErrorGoal{}, places, {}, {pool_, context_}};
  }

  std::optional<GatherPlan> plan_with(const RadianceCache& cache, GatherMeasure& measure) const {
    return measure.plan({{device_, optics_, world_}, cells_, cache});
  }
  /// The error of frames of this scene, with light from `cache`.
  FrameError error_with(const RadianceCache& cache, GatherMeasure& measure) const {
    return measure.check({{device_, optics_, world_}, cells_, cache}, {.error = 0.002f}, {});
  }
  const RadianceCache& cache() const { return cache_; }
  void stop() const { context_.cancelled = true; }

 private:
  static SmallScene scene_below(float light) {
    SmallScene s;
    s.scene.max_depth = 3;
    s.scene.background.horizon = s.scene.background.zenith = Vec3f(light);
    const int matt = s.material(matte(Vec3f(0.5f)));
    s.add(Boxes{{{-4.0f, -1.2f, -4.0f}, {4.0f, -1.0f, 4.0f}}, {{-4.0f, -4.0f, -4.0f}, {4.0f, 4.0f, -3.0f}}}, matt);
    return s;
  }

  ThreadPool pool_{1};
  mutable Context context_;
  SmallScene s_;
  Optics optics_ = single_view(64);
  Affine3f world_;
  DeviceScene device_;
  SurfacePlaces places_;
  BeamFootprint beam_{optics_, {}};
  CacheCells cells_{places_, beam_, 8.0f};
  TraceParams params_;
  RadianceCache cache_{1u << 16};
};

TEST(GatherMeasure, light_that_is_right_errs_by_little) {
  const SkyScene scene(0.6f);
  GatherMeasure measure = scene.measure();
  const FrameError found = scene.error_with(scene.cache(), measure);
  EXPECT_LT(found.pixels, 2.0f * measure.goal().pixels);
  EXPECT_LT(found.blocks, 0.25f / (255.0f * 255.0f));  // half a code
}

// Surfaces of albedo 0.5 that are lit by a sky of 0.6, mostly, look like 0.3 or less: with light that is a fifth darker, what
// they look like is 0.24, too dark by what sRGB's curve makes of it, over the whole of the pixels that show a surface.
TEST(GatherMeasure, light_that_is_wrong_is_found_in_pixels_and_in_means_alike) {
  const SkyScene scene(0.6f), darker(0.48f);
  GatherMeasure measure = scene.measure();
  const FrameError found = scene.error_with(darker.cache(), measure);
  const double step = srgb_from_linear(0.3f) - srgb_from_linear(0.24f);
  EXPECT_GT(found.blocks, 0.3 * step * step);  // where walls meet it is darker
  EXPECT_LT(found.blocks, 1.5 * step * step);
  EXPECT_NEAR(found.blocks, found.pixels, 0.1 * found.pixels);
  EXPECT_GT(found.blocks - 1.65f * found.block_uncertainty, measure.goal().blocks);
}

// A sky of 2.4 makes surfaces that are whiter than white where least of it is hidden: noise beyond white is cut off, and of the
// fewer paths that frames are checked with there is more than of converged light. Without a jackknife of what is shown, means
// over patches seemed to err by 1.28 squared codes, on average over these frames; with it, by 0.34.
TEST(GatherMeasure, noise_beyond_white_does_not_pass_for_light_that_is_wrong) {
  constexpr std::uint32_t kFrames = 8;
  const SkyScene scene(2.4f);
  double sum = 0.0;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    GatherMeasure measure = scene.measure(frame, kChecking);
    sum += static_cast<double>(scene.error_with(scene.cache(), measure).blocks);
  }
  EXPECT_LT(sum / kFrames * 255.0 * 255.0, 0.7);
}

// Light that is a fifth too dark stays so however finely pixels are sampled: the second trial shows it.
TEST(GatherMeasure, pixels_are_not_refined_where_cells_are_wrong) {
  const SkyScene scene(0.6f), darker(0.48f);
  GatherMeasure right = scene.measure(), wrong = scene.measure();
  const std::optional<GatherPlan> good = scene.plan_with(scene.cache(), right), plan = scene.plan_with(darker.cache(), wrong);
  ASSERT_TRUE(good);
  EXPECT_LT(good->of_cells, 1.0f);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->of_cells, 1.0f);
  EXPECT_GT(plan->expected.blocks, 3.0f * wrong.goal().blocks);
  EXPECT_GE(plan->error, 0.005f);
}

// A plan may take as many paths as half a frame: whoever stops a render does not wait for them.
TEST(GatherMeasure, a_render_that_is_stopped_traces_no_more_patches) {
  const SkyScene scene(0.6f);
  GatherMeasure whole = scene.measure();
  EXPECT_GT(whole.counts().total(), 0u);
  scene.stop();
  GatherMeasure none = scene.measure();
  EXPECT_EQ(none.counts().total(), 0u);
  const std::uint64_t before = whole.counts().total();
  scene.plan_with(scene.cache(), whole);
  EXPECT_EQ(whole.counts().total(), before);
}

TEST(GatherMeasure, every_frame_holds_out_other_pixels) {
  const SkyScene scene(0.6f);
  GatherMeasure a = scene.measure(1), b = scene.measure(1), c = scene.measure(2);
  EXPECT_EQ(scene.error_with(scene.cache(), a).pixels, scene.error_with(scene.cache(), b).pixels);
  EXPECT_NE(scene.error_with(scene.cache(), a).pixels, scene.error_with(scene.cache(), c).pixels);
}

}  // namespace
}  // namespace lippmann

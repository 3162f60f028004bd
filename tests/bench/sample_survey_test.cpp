// Which samples a survey of a matt square finds untouched, of which half lies on either side of x = 0.
#include "bench/sample_survey.hpp"

#include <gtest/gtest.h>

#include "bench/hostile_parts.hpp"
#include "bench/scenes.hpp"
#include "job/job_stage.hpp"
#include "scene/builtin/meshes.hpp"

namespace lippmann::bench {
namespace {

constexpr int kSide = 16;
constexpr std::uint64_t kPixels = kSide * kSide;

/// Without any gloss: a sample is one segment from the eye and one to the light.
MetallicRoughness without_gloss() {
  MetallicRoughness surface = matte(Vec3f(0.5f));
  surface.specular = 0.0f;
  return surface;
}

/// Fills the picture; a point-like light stands above it, beyond what the picture shows.
Scene square_below_light(const MetallicRoughness& surface) {
  Scene scene = empty_scene("square");
  show(scene, builtin::rectangle(Vec3f(0.0f), {3.0f, 0.0f, 0.0f}, {0.0f, 3.0f, 0.0f}), add_material(scene, surface));
  add_point_light(scene, Vec3f(10.0f), add_node(scene, -1, {0.0f, 10.0f, 1.0f}));
  look_at(scene, Vec3f(0.0f), 0.0f, 0.0f, 1.0f, 4.0f);
  return scene;
}

SampleSurvey survey(const MetallicRoughness& surface, const std::vector<HorizonBox>& boxes, SampleKind kind, int spp = 1) {
  RenderParams params = params_of("square");
  params.sampling.integrator = Integrator::kPath;
  params.optics.kind = OpticsKind::kSingle;
  params.optics.size = {kSide, kSide};
  const ThreadPool pool(1);
  const JobStage stage(square_below_light(surface), params, pool);
  const Moment moment = stage.moment_at(0);
  return survey_samples(stage.shot(moment), boxes, {kind, spp, 6, 0});
}

/// Left of x = 0, where only rays to the light come by.
const HorizonBox kBeforeLight{{{-5.0f, 8.0f, -1.0f}, {0.0f, 9.0f, 3.0f}}, 0};
/// Around the left half of the square.
const HorizonBox kLeftHalf{{{-5.0f, -5.0f, -0.01f}, {0.0f, 5.0f, 0.01f}}, 0};

TEST(SampleSurvey, without_boxes_all_is_untouched) {
  const SampleSurvey all = survey(without_gloss(), {}, SampleKind::kGather, 2);
  EXPECT_EQ(all.samples.all, 2 * kPixels);
  EXPECT_EQ(all.samples.untouched, 2 * kPixels);
  EXPECT_EQ(all.rays.all, 4 * kPixels);  // one from the eye, one to the light
  EXPECT_EQ(all.rays.untouched, 4 * kPixels);
  EXPECT_EQ(all.rays_seen_alike, 4 * kPixels);
}

TEST(SampleSurvey, a_box_before_the_light_touches_the_shadow_segments_of_one_half) {
  const SampleSurvey half = survey(without_gloss(), {kBeforeLight}, SampleKind::kGather);
  EXPECT_EQ(half.of(SegmentClass::kCamera).untouched, kPixels);
  EXPECT_EQ(half.of(SegmentClass::kToPoint).all, kPixels);
  EXPECT_EQ(half.of(SegmentClass::kToPoint).untouched, kPixels / 2);
  EXPECT_EQ(half.samples.untouched, kPixels / 2);
  EXPECT_EQ(half.rays.untouched, kPixels);
}

TEST(SampleSurvey, a_box_around_half_of_what_is_seen_touches_both_segments_of_its_samples) {
  const SampleSurvey half = survey(without_gloss(), {kLeftHalf}, SampleKind::kGather);
  EXPECT_EQ(half.of(SegmentClass::kCamera).untouched, kPixels / 2);
  EXPECT_EQ(half.of(SegmentClass::kToPoint).untouched, kPixels / 2);
  EXPECT_EQ(half.samples.untouched, kPixels / 2);
}

TEST(SampleSurvey, a_box_without_end_touches_everything) {
  const SampleSurvey none = survey(without_gloss(), {{{Vec3f(-kInfinity), Vec3f(kInfinity)}, 0}}, SampleKind::kPaths);
  EXPECT_EQ(none.samples.untouched, 0u);
  EXPECT_EQ(none.rays.untouched, 0u);
  for (const SegmentCount& segment : none.segments) EXPECT_EQ(segment.untouched, 0u);
}

TEST(SampleSurvey, what_a_mirror_shows_is_not_seen_alike_by_another_eye) {
  const SampleSurvey mirror = survey(metal(Vec3f(0.9f), 0.0f), {}, SampleKind::kGather);
  EXPECT_EQ(mirror.of(SegmentClass::kMirror).all, kPixels);
  EXPECT_EQ(mirror.samples.untouched, kPixels);
  EXPECT_EQ(mirror.seen_alike, 0u);
}

TEST(SampleSurvey, paths_bounce_where_gathered_samples_end) {
  const SampleSurvey paths = survey(without_gloss(), {}, SampleKind::kPaths);
  EXPECT_EQ(paths.of(SegmentClass::kBounce).all, kPixels);  // into the void
  EXPECT_EQ(survey(without_gloss(), {}, SampleKind::kGather).of(SegmentClass::kBounce).all, 0u);
}

}  // namespace
}  // namespace lippmann::bench

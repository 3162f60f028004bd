#include <gtest/gtest.h>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

RenderParams copied(const RenderParams& scene, std::optional<int> keyframes = {}) {
  return with_reuse(scene, {.choice = ReuseChoice::kCopy, .keyframes = keyframes});
}

TEST(CopiedFrames, equal_traced_frames_for_any_keys) {
  const auto traced = make_frames(small_scene(), frames_from(3, 12)).films();
  EXPECT_EQ(make_frames(with_reuse(small_scene(), {}), frames_from(3, 12)).films(), traced);
  const MadeFrames made = make_frames(copied(small_scene(), 4), frames_from(3, 12), 3);
  EXPECT_EQ(made.films(), traced);
  for (int frame = 3; frame <= 12; ++frame) {
    const FrameReport& report = made.report(frame);
    EXPECT_EQ(report.kind, (frame - 3) % 4 == 0 ? "key" : "in-between");
    EXPECT_EQ(report.reused_pixels + report.rays.primary, 128u * 128);
  }
}

TEST(CopiedFrames, with_many_samples_equal_traced_frames) {
  RenderParams scene = small_scene();
  scene.sampling.spp = 4;
  scene.optics.lens_pixels = {7.3f, 0};
  EXPECT_EQ(make_frames(copied(scene, 4), frames_from(0, 3)).films(), make_frames(scene, frames_from(0, 3)).films());
}

TEST(CopiedFrames, of_filtered_views_equal_traced_frames) {
  RenderParams scene = small_scene("small-balls");
  scene.optics = {.kind = OpticsKind::kMultiview, .size = {256, 48}, .views = {4, 1}};
  scene.sampling.spp = 3;
  const auto points = make_frames(scene, frames_from(0, 5)).films();
  scene.sampling.angular_filter = AngularFilter::kBox;
  const auto beams = make_frames(scene, frames_from(0, 5)).films();
  EXPECT_EQ(make_frames(copied(scene), frames_from(0, 5)).films(), beams);
  EXPECT_NE(beams, points);
}

}  // namespace
}  // namespace lippmann::test

#include <gtest/gtest.h>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

RenderParams interpolated(int keyframes, ReuseParams reuse = {}, RenderParams scene = small_scene()) {
  reuse.choice = ReuseChoice::kInterpolate;
  reuse.keyframes = keyframes;
  return with_reuse(scene, reuse);
}

TEST(InterpolatedFrames, key_frames_are_traced) {
  const MadeFrames traced = make_frames(small_scene(), frames_from(0, 8)),
                   made = make_frames(interpolated(4), frames_from(0, 8));
  for (const int key : {0, 4, 8}) {
    EXPECT_EQ(made.report(key).kind, "key");
    EXPECT_EQ(made.film(key), traced.film(key)) << key;
  }
  for (const int between : {1, 2, 3, 5, 6, 7}) {
    const FrameReport& report = made.report(between);
    EXPECT_EQ(report.kind, "in-between");
    EXPECT_EQ(report.rays.primary, 0u);
    EXPECT_EQ(report.reused_pixels + report.missed_pixels, 128u * 128);
    EXPECT_EQ(report.newly_visible_pixels + report.not_covered_pixels, report.missed_pixels);
    EXPECT_NE(made.film(between), traced.film(between)) << between;
  }
  EXPECT_TRUE(made.sources.empty());
}

TEST(InterpolatedFrames, any_thread_count_gives_the_same_bits) {
  EXPECT_EQ(make_frames(interpolated(4), frames_from(0, 4), 1).films(),
            make_frames(interpolated(4), frames_from(0, 4), 4).films());
}

// Frame 3 is made from frames 0 and 4, and frame 5 from 4 and 8. With halving, frame 3 is made from 2 and 4, and frame
// 5 from 4 and 6.
TEST(InterpolatedFrames, of_a_part_equal_the_whole) {
  const std::vector<std::pair<ReuseParams, std::size_t>> ways{{{.fill = MissedFill::kInterpolate}, 2},
                                                              {{.fill = MissedFill::kRetrace, .halving = true}, 4}};
  for (const auto& [how, sources] : ways) {
    const MadeFrames whole = make_frames(interpolated(4, how), frames_from(0, 9)),
                     part = make_frames(interpolated(4, how), frames_from(3, 5)),
                     scattered = make_frames(interpolated(4, how), {3, 4, 9});
    for (const MadeFrames* some : {&part, &scattered})
      for (const auto& [number, film] : some->films()) EXPECT_EQ(film, whole.film(number)) << number;
    EXPECT_EQ(part.sources.size(), sources);
    std::uint64_t rays = part.report(4).rays.primary;
    for (const FrameReport& source : part.sources) rays += source.rays.primary;
    EXPECT_GE(rays, 3u * 128 * 128);
  }
}

/// The gears turn so far between frames 0 and 16 that interpolation leaves gaps in frame 8.
MadeFrames turned_gears(const ReuseParams& how) { return make_frames(interpolated(16, how, small_scene("gears")), {8}); }

TEST(InterpolatedFrames, retracing_missed_pixels_reduces_the_error) {
  const MadeFrames traced = make_frames(small_scene("gears"), {8}), filled = turned_gears({}),
                   retraced = turned_gears({.fill = MissedFill::kRetrace});
  EXPECT_GT(psnr_between(traced, retraced, 8), psnr_between(traced, filled, 8));
  const FrameReport& report = retraced.report(8);
  EXPECT_GT(report.missed_pixels, 0u);
  EXPECT_EQ(report.retraced_pixels, report.missed_pixels);
  EXPECT_EQ(report.rays.primary, report.missed_pixels);
}

TEST(InterpolatedFrames, for_debugging_differ) {
  const MadeFrames good = turned_gears({});
  for (const ReuseParams& how :
       {ReuseParams{.debug = DebugPicture::kMissed}, ReuseParams{.no_z_buffer = true}, ReuseParams{.splat = SplatMode::kLens}})
    EXPECT_NE(turned_gears(how).film(8), good.film(8));
}

TEST(InterpolatedFrames, halving_reuses_the_middle_frame) {
  const MadeFrames keys_only = make_frames(interpolated(4), frames_from(0, 4)),
                   halved = make_frames(interpolated(4, {.halving = true}), frames_from(0, 4));
  EXPECT_EQ(halved.film(2), keys_only.film(2));
  EXPECT_NE(halved.film(1), keys_only.film(1));
  EXPECT_NE(halved.film(3), keys_only.film(3));
}

TEST(InterpolatedFrames, are_made_for_every_kind_of_optics) {
  const std::vector<OpticsParams> kinds{{.lens_pixels = {13.776f, 0}, .size = {90, 50}, .slant_deg = -9.46f},
                                        {.kind = OpticsKind::kMicrolens, .lenses = {10, 6}, .lens_pixels = {5, 0}},
                                        {.kind = OpticsKind::kMicrolens, .packing = LensPacking::kHexagonal, .lenses = {10, 0}},
                                        {.kind = OpticsKind::kMultiview, .size = {60, 40}, .views = {3, 2}},
                                        {.kind = OpticsKind::kSingle, .size = {33, 21}}};
  for (const OpticsParams& optics : kinds) {
    RenderParams scene = small_scene();
    scene.optics = optics;
    const MadeFrames made = make_frames(interpolated(4, {}, scene), {2});
    EXPECT_EQ(made.report(2).kind, "in-between");
    EXPECT_GT(made.report(2).reused_pixels, static_cast<std::uint64_t>(made.pixels * 8 / 10)) << made.pixels;
  }
}

}  // namespace
}  // namespace lippmann::test

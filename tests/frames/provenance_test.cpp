#include <gtest/gtest.h>

#include <array>

#include "frames/made_frames.hpp"

namespace lippmann::test {
namespace {

RenderParams with_provenance(RenderParams params) {
  params.sampling.aov.push_back(Aov::kProvenance);
  return params;
}

const Image& provenance(const MadeFrames& made, int frame) { return made.frames.at(frame).pictures.aovs[Aov::kProvenance]; }

std::array<std::uint64_t, std::size(kProvenanceInfos)> count(const MadeFrames& made, int frame) {
  std::array<std::uint64_t, std::size(kProvenanceInfos)> counts{};
  for (const float code : provenance(made, frame).data) ++counts.at(static_cast<std::size_t>(code));
  return counts;
}

std::uint64_t count(const MadeFrames& made, int frame, Provenance from) {
  return count(made, frame)[static_cast<std::size_t>(from)];
}

constexpr std::uint64_t kPixels = 128 * 128;

MadeFrames frames_with_provenance(const RenderParams& params, const std::vector<int>& frames, int threads = 2) {
  const MadeFrames made = make_frames(with_provenance(params), frames, threads);
  EXPECT_EQ(made.films(), make_frames(params, frames).films());
  for (const auto& [number, frame] : made.frames)
    EXPECT_EQ(frame.pictures.aovs[Aov::kProvenance].data.size(), frame.pictures.film.data.size() / 3) << number;
  return made;
}

RenderParams interpolated(const char* scene, ReuseParams how = {}) {
  how.choice = ReuseChoice::kInterpolate;
  how.keyframes = 16;
  return with_reuse(small_scene(scene), how);
}

TEST(Provenance, of_traced_frames_is_traced) {
  const MadeFrames made = frames_with_provenance(small_scene(), {0, 1});
  EXPECT_EQ(count(made, 1, Provenance::kTraced), kPixels);
}

TEST(Provenance, of_copied_frames_marks_copied_pixels) {
  const MadeFrames made =
      frames_with_provenance(with_reuse(small_scene(), {.choice = ReuseChoice::kCopy, .keyframes = 4}), frames_from(0, 3));
  EXPECT_EQ(count(made, 0, Provenance::kTraced), kPixels);
  for (const int frame : {1, 2, 3}) {
    EXPECT_EQ(count(made, frame, Provenance::kCopied), made.report(frame).reused_pixels) << frame;
    EXPECT_EQ(count(made, frame, Provenance::kTraced), made.report(frame).rays.primary) << frame;
    EXPECT_GT(count(made, frame, Provenance::kCopied), 0u) << frame;
    for (std::size_t value = 0; value < 3 * kPixels; ++value)
      if (provenance(made, frame).data[value / 3] == static_cast<float>(Provenance::kCopied)) {
        ASSERT_EQ(made.film(frame)[value], made.film(0)[value]) << frame << ", pixel " << value / 3;
      }
  }
}

TEST(Provenance, of_interpolated_frames_matches_the_report) {
  const std::vector<std::pair<MissedFill, Provenance>> ways{{MissedFill::kInterpolate, Provenance::kFilled},
                                                            {MissedFill::kRetrace, Provenance::kRetraced},
                                                            {MissedFill::kBlack, Provenance::kBlack}};
  for (const auto& [fill, expected] : ways) {
    RenderParams params = interpolated("gears", {.fill = fill});
    if (fill == MissedFill::kBlack) params.reuse.fill = {}, params.reuse.debug = DebugPicture::kMissed;
    const MadeFrames made = frames_with_provenance(params, {0, 8});
    EXPECT_EQ(count(made, 0, Provenance::kTraced), kPixels);
    EXPECT_GT(made.report(8).missed_pixels, 0u);
    EXPECT_EQ(count(made, 8, expected), made.report(8).missed_pixels);
    EXPECT_EQ(count(made, 8, Provenance::kInterpolated), kPixels - made.report(8).missed_pixels);
  }
}

TEST(Provenance, of_black_pixels_is_missed) {
  RenderParams params = interpolated("gears");
  params.reuse.debug = DebugPicture::kMissed;
  const MadeFrames made = frames_with_provenance(params, {8});
  for (std::size_t value = 0; value < 3 * kPixels; ++value)
    if (provenance(made, 8).data[value / 3] == static_cast<float>(Provenance::kBlack)) {
      ASSERT_EQ(made.film(8)[value], 0.0f) << value / 3;
    }
}

TEST(Provenance, of_halved_frames_includes_sources) {
  const MadeFrames made = frames_with_provenance(interpolated("gears", {.halving = true}), {4, 8});
  for (const int frame : {4, 8})
    EXPECT_EQ(count(made, frame, Provenance::kInterpolated) + count(made, frame, Provenance::kFilled), kPixels) << frame;
}

TEST(Provenance, of_frames_with_min_psnr_marks_traced_pixels) {
  int predicted = 0;
  for (const char* scene : {"room", "teapot"}) {
    RenderParams params = with_reuse(small_scene(scene), {.choice = ReuseChoice::kInterpolate, .min_psnr_db = 32.0});
    params.optics.lenses = {32, 0};
    const MadeFrames made = frames_with_provenance(params, frames_from(40, 48));
    const auto pixels = static_cast<std::uint64_t>(made.pixels);
    for (const auto& [number, frame] : made.frames) {
      const std::uint64_t traced = count(made, number, Provenance::kTraced) + count(made, number, Provenance::kRetraced);
      EXPECT_EQ(traced, frame.report.kind == "in-between" ? frame.report.retraced_pixels : pixels) << number;
      EXPECT_EQ(traced + count(made, number, Provenance::kInterpolated) + count(made, number, Provenance::kFilled), pixels);
      predicted += frame.report.kind == "in-between" ? 1 : 0;
    }
  }
  EXPECT_GT(predicted, 0);
}

TEST(Provenance, of_denoised_frames_equals_noisy_frames) {
  RenderParams params = small_scene();
  params.optics.lenses = {8, 0};
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = 4;
  const MadeFrames made = frames_with_provenance(params, {1});
  EXPECT_EQ(count(made, 1, Provenance::kTraced), provenance(made, 1).data.size());
}

// Unlike the provenance, all other layers require that every pixel is traced.
TEST(Provenance, does_not_change_reuse) {
  const FrameParams params{with_provenance(small_scene()).sampling, AutoReuse{}};
  EXPECT_STREQ(name_of(resolved_reuse(params)), "copy");
  EXPECT_NO_THROW(check({params.sampling, CopySettled{}}));
  EXPECT_NO_THROW(check({params.sampling, Interpolate{}}));
  FrameParams more = params;
  more.sampling.aov.push_back(Aov::kDepth);
  EXPECT_STREQ(name_of(resolved_reuse(more)), "none");
  EXPECT_ANY_THROW(check({more.sampling, Interpolate{}}));
}

}  // namespace
}  // namespace lippmann::test

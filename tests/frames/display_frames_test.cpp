#include <gtest/gtest.h>

#include "frames/made_frames.hpp"
#include "support/small_panel.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

class DisplayFrames : public testing::Test {
 protected:
  DisplayFrames() { write_small_panel(dir_ / "panel.toml"); }

  RenderParams on_panel(const char* scene, std::optional<PictureLayout> layout, const ReuseParams& reuse) const {
    RenderParams params;
    params.scene.name = scene;
    params.optics.display = (dir_ / "panel.toml").string();
    params.output.pictures.layout = layout;
    return with_reuse(params, reuse);
  }

  TempDir dir_;
};

TEST_F(DisplayFrames, of_native_pixels_are_copied_exactly) {
  const auto made = [&](ReuseChoice choice) {
    return make_frames(on_panel("tree", PictureLayout::kNative, {.choice = choice}), frames_from(3, 6));
  };
  const MadeFrames traced = made(ReuseChoice::kNone), copied = made(ReuseChoice::kCopy);
  EXPECT_EQ(traced.film(3).size(), 3u * 3 * 48 * 64) << "three colours of three sub-pixels each";
  EXPECT_EQ(copied.films(), traced.films());
}

// Interpolated frames have a PSNR of 30.9 dB. Copies of the key frame would have 27.9 dB.
TEST_F(DisplayFrames, of_native_pixels_interpolate_accurately) {
  const MadeFrames traced = make_frames(on_panel("teapot", PictureLayout::kNative, {.choice = ReuseChoice::kNone}), {1, 2, 3});
  const MadeFrames made =
      make_frames(on_panel("teapot", PictureLayout::kNative, {.choice = ReuseChoice::kInterpolate, .keyframes = 4}), {1, 2, 3});
  double sum = 0.0;
  for (const int between : {1, 2, 3}) {
    EXPECT_EQ(made.report(between).kind, "in-between");
    sum += psnr_between(traced, made, between);
  }
  EXPECT_GE(sum / 3.0, 30.0);
}

TEST_F(DisplayFrames, of_quilts_are_filtered_by_default) {
  const auto film = [&](std::optional<AngularFilter> filter) {
    RenderParams params = on_panel("teapot", {}, {.choice = ReuseChoice::kNone});
    params.sampling.spp = 4;
    params.sampling.angular_filter = filter;
    return make_frames(params, {3}).film(3);
  };
  EXPECT_EQ(film({}), film(AngularFilter::kBox));
  EXPECT_NE(film({}), film(AngularFilter::kNone));
}

}  // namespace
}  // namespace lippmann::test

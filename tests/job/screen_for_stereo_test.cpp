// By similar triangles, eyes `ipd` apart at distance D see a point at depth d behind the screen with the disparity ipd
// * d / (D + d).
#include "job/screen_for_stereo.hpp"

#include <gmock/gmock.h>

#include "folder/frame_layout.hpp"
#include "job/optics_on.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

RenderParams stereo_params() {
  RenderParams params;
  params.output.pictures.layout = PictureLayout::kStereo;
  params.optics.size = {1200, 300};
  params.optics.viewing_distance_mm = 600.0f;
  return params;
}

Optics optics_for(const RenderParams& params, const Display* display = nullptr) {
  FittedArray array;
  array.plane_height = 8.0f, array.viewing_distance = 24.0f;
  return test::optics_on(array, params, display).optics;
}

Vec2d disparity_mm(const Optics& optics, Vec3f point) {
  std::vector<Vec2f> pixels;
  pixels_seeing(optics, point, pixels);
  EXPECT_EQ(pixels.size(), 2u);
  const float view = 0.5f * static_cast<float>(optics.panel.width);
  const Vec2f moved = pixels.at(1) - pixels.at(0) - Vec2f(view, 0.0f);
  return Vec2d(moved) * static_cast<double>(optics.panel.pixel_pitch_mm);
}

TEST(ScreenForStereo, disparity_follows_similar_triangles) {
  const Optics optics = optics_for(stereo_params());
  EXPECT_NEAR(disparity_mm(optics, {0, 0, 0}).x, 0.0, 1e-3) << "in the plane of the screen";
  EXPECT_NEAR(disparity_mm(optics, {0, 0, -600}).x, 31.5, 1e-3) << "63 600 / 1200 behind it";
  EXPECT_NEAR(disparity_mm(optics, {0, 0, 300}).x, -63.0, 1e-3) << "63 (-300) / 300 in front of it";
}

TEST(ScreenForStereo, eyes_never_toe_in) {
  const Optics optics = optics_for(stereo_params());
  for (const Vec3f point : {Vec3f(150, 90, -600), Vec3f(-150, 90, -600), Vec3f(80, -60, 100)}) {
    const Vec2d moved = disparity_mm(optics, point);
    EXPECT_NEAR(moved.y, 0.0, 1e-3) << "no vertical disparity anywhere";
    EXPECT_NEAR(moved.x, -63.0 * point.z / (600.0 - point.z), 1e-3) << "the same all over the screen";
  }
}

TEST(ScreenForStereo, ipd_and_screen_width_are_as_given) {
  RenderParams params = stereo_params();
  params.optics.ipd_mm = 50.0, params.optics.screen_width_mm = 1200.0;
  const Optics optics = optics_for(params);
  EXPECT_FLOAT_EQ(optics.panel.pixel_pitch_mm, 2.0f);
  EXPECT_NEAR(disparity_mm(optics, {0, 0, -200}).x, 12.5, 1e-3);  // ipd * d / (D + d) = 50 * 200 / (600 + 200)
}

TEST(ScreenForStereo, squeezed_views_see_the_same_screen) {
  RenderParams params = stereo_params();
  params.output.pictures.stereo.packing = StereoPacking::kHalfSideBySide;
  params.optics.size = {600, 300};
  const Optics half = optics_for(params);
  EXPECT_EQ(film_size(half), Vec2i(600, 300));
  EXPECT_EQ(window_size_mm(half), Vec2f(600, 300));
  EXPECT_NEAR(disparity_mm(half, {0, 0, -600}).x, 31.5, 1e-3);
  params.output.pictures.stereo.packing = StereoPacking::kHalfOverUnder;
  const Optics over = optics_for(params);
  EXPECT_EQ(film_size(over), Vec2i(1200, 150)) << "traced side by side";
  EXPECT_EQ(window_size_mm(over), Vec2f(600, 300));
}

TEST(ScreenForStereo, display_is_the_screen) {
  const Display display = load_display("portrait");
  RenderParams params;
  params.output.pictures.to = "stereo";
  const Optics optics = optics_for(params, &display);
  EXPECT_EQ(film_size(optics), Vec2i(2 * 1536, 2048));
  EXPECT_NEAR(window_size_mm(optics).x, display.size_mm().x, 1e-3);
  EXPECT_NEAR(viewing_distance_mm(optics), viewing_distance_mm(display), 1e-3);
}

TEST(ScreenForStereo, all_depth_is_shown_by_default) {
  EXPECT_EQ(depth_budget_mm(optics_for(stereo_params())), kInfinity) << "no eye passes from one view to the other";
}

TEST(ScreenForStereo, picture_takes_the_pixels_of_its_packing) {
  RenderParams params = stereo_params();
  params.optics.size = {4, 2};
  params.output.pictures.stereo = {StereoPacking::kOverUnder, true};
  const Optics optics = optics_for(params);
  const FrameLayout layout(params.output.pictures, optics);
  ASSERT_EQ(film_size(optics), Vec2i(8, 1));
  Image film(8, 1, 1);
  film.data = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(layout.picture_size(), Vec2i(4, 2));
  EXPECT_THAT(layout.arrange(film).data, testing::ElementsAre(5, 6, 7, 8, 1, 2, 3, 4)) << "the right eye's on top";
  EXPECT_EQ(layout.names().suffix, "_ou_rl");
  EXPECT_EQ(layout.video_path("out/a.mp4"), "out/a_ou_rl.mp4");
}

TEST(ScreenForStereo, parameters_of_other_optics_are_refused) {
  RenderParams params = stereo_params();
  params.optics.size = {1201, 300};
  EXPECT_THAT(error_message([&] { optics_for(params); }), HasSubstr("1201x300 pixels do not hold two views"));
  params = stereo_params();
  params.optics.kind = OpticsKind::kLenticular;
  EXPECT_THAT(error_message([&] { optics_for(params); }), HasSubstr("has no effect on a stereo picture"));
  params = stereo_params();
  params.optics.viewing_distance_mm = kInfinity;
  EXPECT_THAT(error_message([&] { optics_for(params); }), HasSubstr("cannot be infinite"));
  params = {};
  params.optics.ipd_mm = 60.0;
  EXPECT_THAT(error_message([&] { optics_for(params); }), HasSubstr("has no effect without two eyes"));
}

}  // namespace
}  // namespace lippmann

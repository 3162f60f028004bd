#include "layout/cameras.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "formats/hci_parameters.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::numbered_field;
using testing::AllOf;
using testing::HasSubstr;

/// Expects that the ray of every pixel passes through its view's eye and crosses z = 0 where the camera states.
/// Single-precision rays 500 mm from the eye are exact to a few times 1e-6 of that distance.
void expect_cameras_of_rays(const Optics& optics) {
  const RenderedViews views = rendered_views(optics).value();
  const ViewCameras& cameras = views.cameras.value();
  const Vec2i picture(optics.panel.width, optics.panel.height);
  const Vec2i size = view_size(views.film, picture, "");
  const std::vector<std::uint32_t> pixels = pixels_of_views(views.film, size, picture);
  ASSERT_EQ(cameras.eyes_mm.size(), static_cast<std::size_t>(views.film.grid.count()));
  for (std::size_t i = 0; i < pixels.size(); i += 7) {
    const auto in_view = static_cast<int>(i) % (size.x * size.y);
    const Vec2d pixel(in_view % size.x + 0.5, in_view / size.x + 0.5),
        eye = cameras.eyes_mm[i / static_cast<std::size_t>(size.x * size.y)];
    const Vec2f at(static_cast<float>(pixels[i] % static_cast<std::uint32_t>(picture.x)) + 0.5f,
                   static_cast<float>(pixels[i] / static_cast<std::uint32_t>(picture.x)) + 0.5f);
    const Ray ray = ray_of_pixel(optics, at);
    const auto where = [&](double z) {
      const double t = (z - static_cast<double>(ray.origin.z)) / static_cast<double>(ray.direction.z);
      return Vec2d(ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y);
    };
    const Vec2d in_plane = (pixel - cameras.centre_px) * cameras.pixel_mm * Vec2d(1.0, -1.0);
    ASSERT_NEAR(where(0.0).x, in_plane.x, 2e-3) << i;
    ASSERT_NEAR(where(0.0).y, in_plane.y, 2e-3) << i;
    ASSERT_NEAR(where(cameras.distance_mm).x, eye.x, 2e-3) << i;
    ASSERT_NEAR(where(cameras.distance_mm).y, eye.y, 2e-3) << i;
  }
}

Optics camera_grid() {
  MultiView views{.columns = 3, .rows = 2, .distance_mm = 500.0f};
  views.baseline_mm = 12.0f;
  return {.panel = {3 * 20, 2 * 14, 1.5f}, .model = views};
}

TEST(Cameras, quilts_and_camera_grids_match_ray_origins) {
  expect_cameras_of_rays(camera_grid());
  expect_cameras_of_rays({.panel = {80, 30, 1.0f}, .model = MultiView{4, 2, radians(40.0f), false, 500.0f}});
  expect_cameras_of_rays({.panel = {30, 20, 1.0f}, .model = SingleView{500.0f, {0.25f, -0.5f}}});
}

TEST(Cameras, near_lens_arrays_match_ray_crossings) {
  // The cell below a lens has 5 pixels of 0.2 mm, so it is 1 mm wide. It is 2 mm behind the lens and is seen from 500
  // mm, so the lens pitch is 1 mm / (1 + 2 / 500).
  const float pitch = 1.0f / (1.0f + 2.0f / 500.0f);
  MicrolensArray array{.lens_pitch_mm = pitch, .gap_mm = 2.0f, .offset_mm = Vec2f(0.0f), .viewing_distance_mm = 500.0f};
  expect_cameras_of_rays({.panel = {45, 35, 0.2f}, .model = array});
  LenticularSheet sheet{
      .lens_pitch_mm = pitch, .gap_mm = 2.0f, .offset_mm = 0.0f, .viewing_distance_mm = 500.0f, .eye_height_mm = 30.0f};
  expect_cameras_of_rays({.panel = {45, 20, 0.2f}, .model = sheet});
  const ViewCameras cameras = rendered_views({.panel = {45, 35, 0.2f}, .model = array})->cameras.value();
  EXPECT_NEAR(common_baseline_mm(cameras, {5, 5}).value(), 0.2 * 500.0 / 2.0, 1e-5) << "m V / g";
}

TEST(Cameras, of_fitted_depth_stand_nearer_together) {
  const float pitch = 1.0f / (1.0f + 2.0f / 500.0f);
  const MicrolensArray array{.lens_pitch_mm = pitch, .gap_mm = 2.0f, .offset_mm = Vec2f(0.0f), .viewing_distance_mm = 500.0f};
  const LenticularSheet sheet{.lens_pitch_mm = pitch, .gap_mm = 2.0f, .offset_mm = 0.0f, .viewing_distance_mm = 500.0f};
  const MultiView quilt{4, 2, radians(40.0f), false, 500.0f};
  expect_cameras_of_rays(with_parallax({.panel = {45, 35, 0.2f}, .model = array}, 0.25f));
  expect_cameras_of_rays(with_parallax({.panel = {45, 20, 0.2f}, .model = sheet}, 0.25f));
  expect_cameras_of_rays(with_parallax({.panel = {80, 30, 1.0f}, .model = quilt}, 0.25f));
}

TEST(Cameras, parallel_projections_have_no_cameras) {
  const RenderedViews parallel = rendered_views({.panel = {48, 20, 0.125f}, .model = LenticularSheet{}}).value();
  EXPECT_EQ(parallel.film.grid, (ViewGrid{8, 1}));
  EXPECT_FALSE(parallel.cameras);
  EXPECT_FALSE(rendered_views({.panel = {40, 20, 0.125f}, .model = LenticularSheet{.slant = 0.1f}}));
}

TEST(Cameras, equal_angles_have_no_common_baseline) {
  const RenderedViews cone =
      rendered_views({.panel = {80, 30, 1.0f}, .model = MultiView{4, 2, radians(40.0f), false, 500.0f}}).value();
  EXPECT_FALSE(common_baseline_mm(*cone.cameras, cone.film.grid));
  const RenderedViews grid = rendered_views(camera_grid()).value();
  EXPECT_NEAR(common_baseline_mm(*grid.cameras, grid.film.grid).value(), 12.0, 1e-5);
}

/// Baseline b = 6 mm, focal length f = 100 mm, focus distance F = 1150 mm, sensor width s = 35 mm with n = 512 pixels.
HciParameters by_hand() {
  HciParameters p;
  p.baseline_mm = 6.0, p.focal_length_mm = 100.0, p.focus_distance_m = 1.15, p.sensor_size_mm = 35.0;
  p.width = 512, p.height = 384;
  return p;
}

TEST(HciDisparity, zero_in_focus_7_63_at_infinity) {
  // Disparity at infinity: b f n / (F s) = 6 * 100 * 512 / (1150 * 35) = 7.63230 px, with baseline b, focal length f,
  // width n in pixels, focus distance F and sensor width s.
  EXPECT_EQ(hci_disparity_px(by_hand(), 1.15), 0.0);
  EXPECT_NEAR(hci_disparity_px(by_hand(), INFINITY), -7.63230, 1e-5);
  EXPECT_NEAR(hci_disparity_px(by_hand(), 0.575), 7.63230, 1e-5) << "half the focus distance: positive";
}

TEST(HciDisparity, equals_point_motion_between_grid_views) {
  const Optics optics = camera_grid();
  const RenderedViews views = rendered_views(optics).value();
  LightField field = numbered_field(views.film.grid, {20, 14});
  field.cameras = views.cameras;
  const HciParameters p = hci_parameters(field, "a");
  for (const float z : {-300.0f, -20.0f, 40.0f}) {
    std::vector<Vec2f> seen;
    pixels_seeing(optics, {0.7f, -0.4f, z}, seen);
    ASSERT_EQ(seen.size(), 6u);
    const double d = hci_disparity_px(p, 1e-3 * (500.0 - static_cast<double>(z)));
    // In the quilt, view 1 begins 20 pixels to the right of view 0, and view 3 begins 14 pixels above it.
    EXPECT_NEAR(seen[1].x - 20.0f - seen[0].x, -d, 1e-4) << "to the left as the eye moves right";
    EXPECT_NEAR(seen[3].y + 14.0f - seen[0].y, d, 1e-4) << "downwards as the eye moves up";
  }
}

TEST(HciParameters, text_brings_back_what_was_written) {
  HciParameters p = by_hand();
  p.columns = 9, p.rows = 7;
  p.notes = {.centre_camera_m = Vec3d(0.5, -1.0, 3.0), .scene = "room", .authors = "Ada", .disparity_px = {-1.25, 2.5}};
  const std::string text = hci_parameters_text(p);
  const HciParameters back = parse_hci_parameters(text, "a");
  EXPECT_EQ(hci_parameters_text(back), text);
  EXPECT_EQ(back.columns, 9);
  EXPECT_EQ(back.focus_distance_m, 1.15);
  EXPECT_EQ(back.notes, p.notes);
  EXPECT_THAT(text,
              AllOf(HasSubstr("[intrinsics]"), HasSubstr("[extrinsics]"), HasSubstr("[meta]"), HasSubstr("offset = 7.632")));
}

TEST(HciParameters, cameras_come_back_through_them) {
  LightField field = numbered_field({3, 2}, {20, 14});
  field.cameras = rendered_views(camera_grid())->cameras;
  const ViewCameras back = hci_cameras(hci_parameters(field, "a"));
  EXPECT_NEAR(back.distance_mm, 500.0, 1e-9);
  EXPECT_NEAR(back.pixel_mm.x, 1.5, 1e-9);
  for (std::size_t view = 0; view < 6; ++view) EXPECT_LT(glm::distance(back.eyes_mm[view], field.cameras->eyes_mm[view]), 1e-5);
}

TEST(HciParameters, what_the_format_cannot_say_is_refused) {
  LightField field = numbered_field({8, 1}, {20, 15});
  field.cameras = rendered_views({.panel = {80, 30, 1.0f}, .model = MultiView{4, 2, radians(40.0f), false, 500.0f}})->cameras;
  EXPECT_THAT(error_message([&] { hci_parameters(field, "a"); }),
              AllOf(HasSubstr("spacing of the views is not uniform"), HasSubstr("`camera-grid`")));
  field.cameras = rendered_views(camera_grid())->cameras;
  field.grid = {3, 2};
  field.cameras->pixel_mm.y *= 1.1;
  EXPECT_THAT(error_message([&] { hci_parameters(field, "a"); }), HasSubstr("not square"));
}

TEST(HciParameters, files_that_make_no_cameras_are_refused) {
  const std::string good = hci_parameters_text(by_hand());
  const auto refusal = [&](const std::string& key, const std::string& value) {
    std::string text = good;
    const std::size_t at = text.find(key + " = "), end = text.find('\n', at);
    text.replace(at, end - at, value.empty() ? "" : key + " = " + value);
    return error_message([&] { parse_hci_parameters(text, "p.cfg"); });
  };
  EXPECT_THAT(refusal("baseline_mm", ""), AllOf(HasSubstr("p.cfg"), HasSubstr("has no baseline_mm")));
  for (const char* value : {"nan", "-1", "6mm", "1e400", "inf"})
    EXPECT_THAT(refusal("baseline_mm", value), HasSubstr("baseline_mm is")) << value;
  EXPECT_THAT(refusal("num_cams_x", "9.5"), HasSubstr("whole number"));
  EXPECT_THAT(refusal("image_resolution_x_px", "1000000"), HasSubstr("1 to 65536"));
  EXPECT_THAT(refusal("focus_distance_m", "0"), HasSubstr("focus_distance_m"));
}

}  // namespace
}  // namespace lippmann

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "job/optics_on.hpp"
#include "job/param_text.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/optics/view_cameras.hpp"
#include "lippmann/optics/viewing.hpp"
#include "optics/view_spacing.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

Optics optics_of(const RenderParams& params, const Display* display = nullptr) {
  FittedArray array;
  array.plane_height = 8.0f, array.viewing_distance = 24.0f;
  return test::optics_on(array, params, display).optics;
}

RenderParams sweep_params() {
  RenderParams params;
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {23, 1}, params.optics.size = {920, 30};
  params.optics.view_angle_deg = 45.0f, params.optics.viewing_distance_mm = 500.0f;
  return params;
}

double angle_of_eye_deg(const Optics& optics, std::size_t view) {
  const ViewCameras cameras = view_cameras(optics).value();
  return std::atan(cameras.eyes_mm.at(view).x / cameras.distance_mm) * 180.0 / std::numbers::pi;
}

TEST(ScreenEyes, cone_ends_take_one_step_less) {
  RenderParams params = sweep_params();
  const Optics inside = optics_of(params);
  EXPECT_NEAR(angle_of_eye_deg(inside, 0), -22.5 + 0.5 * 45.0 / 23.0, 1e-4);
  EXPECT_NEAR(angle_of_eye_deg(inside, 12) - angle_of_eye_deg(inside, 11), 1.9565, 5e-5);
  EXPECT_EQ(view_spacing(inside), "23 views 1.9565 degrees apart, the outermost half a step inside the ends of 45 degrees");
  params.optics.cone_ends = true;
  const Optics ends = optics_of(params);
  EXPECT_NEAR(angle_of_eye_deg(ends, 0), -22.5, 1e-4);
  EXPECT_NEAR(angle_of_eye_deg(ends, 22), 22.5, 1e-4);
  EXPECT_NEAR(angle_of_eye_deg(ends, 12) - angle_of_eye_deg(ends, 11), 2.0455, 5e-5);
  EXPECT_EQ(view_spacing(ends), "23 views 2.0455 degrees apart, the outermost at the ends of 45 degrees");
}

TEST(ScreenEyes, cameras_on_a_track_reach_its_ends) {
  RenderParams params = sweep_params();
  params.optics.camera_grid = true, params.optics.cone_ends = true;
  const ViewCameras cameras = view_cameras(optics_of(params)).value();
  const double half_track = 500.0 * std::tan(22.5 * std::numbers::pi / 180.0);
  EXPECT_NEAR(cameras.eyes_mm.front().x, -half_track, 1e-3);
  EXPECT_NEAR(cameras.eyes_mm.back().x, half_track, 1e-3);
  EXPECT_NEAR(cameras.eyes_mm[1].x - cameras.eyes_mm[0].x, 2.0 * half_track / 22.0, 1e-4);
}

TEST(ScreenEyes, quilt_of_a_display_has_cone_ends) {
  const Display portrait = load_display("portrait");
  RenderParams params;
  params.optics.cone_ends = true;
  EXPECT_EQ(view_spacing(optics_of(params, &portrait)),
            "48 views 0.85106 degrees apart, the outermost at the ends of 40 degrees");
  params.output.pictures.layout = PictureLayout::kNative;
  EXPECT_THAT(error_message([&] { optics_of(params, &portrait); }), HasSubstr("--cone-ends"));
}

/// Returns the height in mm at which the pixels that see a point show it in the plane z = 0.
double height_mm(const Optics& optics, Vec3f point) {
  std::vector<Vec2f> pixels;
  pixels_seeing(optics, point, pixels);
  EXPECT_FALSE(pixels.empty());
  std::vector<double> heights;
  for (const Vec2f pixel : pixels) {
    const Ray ray = ray_of_pixel(optics, pixel);
    heights.push_back(ray.origin.y - ray.direction.y * (ray.origin.z / ray.direction.z));
    EXPECT_NEAR(heights.back(), heights.front(), 2e-3);
  }
  return heights.at(0);
}

TEST(ScreenEyes, eye_above_moves_depth_by_its_height) {
  // Height of the display: 2048 / 324 * 25.4 = 160.553 mm. Viewing distance: D = 160.553 / 2 / tan(7 degrees) = 653.800
  // mm. Eye 30 degrees above the middle: y_e = D tan(30 degrees) = 377.472 mm.
  const Display portrait = load_display("portrait");
  const double y_e = 377.472, d = 653.800;
  for (const char* kind : {"quilt", "native", "single", "stereo"}) {
    RenderParams params;
    params.optics.fit_depth = false;
    if (kind == std::string("native")) params.output.pictures.layout = PictureLayout::kNative;
    if (kind == std::string("stereo")) params.output.pictures.layout = PictureLayout::kStereo;
    if (kind == std::string("single")) params.optics.kind = OpticsKind::kSingle;
    const Optics level = optics_of(params, &portrait);
    params.optics.eye_height = EyeHeight{30.0f, true};
    const Optics above = optics_of(params, &portrait);
    EXPECT_NEAR(default_eye_mm(above).y, y_e, 2e-3) << kind;
    for (const double z : {0.0, -40.0, 25.0}) {
      const Vec3f point(3.0f, 10.0f, static_cast<float>(z));
      EXPECT_NEAR(height_mm(above, point) - height_mm(level, point), -y_e * z / (d - z), 2e-3) << kind << " at " << z;
    }
  }
}

TEST(ScreenEyes, eye_height_survives_fitted_depth) {
  const Display portrait = load_display("portrait");
  RenderParams params;
  params.optics.eye_height = EyeHeight{-120.0f, false};
  for (const bool fits : {false, true}) {
    params.optics.fit_depth = fits;
    EXPECT_FLOAT_EQ(std::get<MultiView>(optics_of(params, &portrait).model).eye_height_mm, -120.0f);
  }
}

TEST(ScreenEyes, sheets_have_eyes_at_a_height) {
  RenderParams params;
  params.optics.viewing_distance_mm = 400.0f, params.optics.eye_height = EyeHeight{-45.0f, true};
  EXPECT_NEAR(std::get<LenticularSheet>(optics_of(params).model).eye_height_mm, -400.0f, 1e-3);
  params.optics.viewing_distance_mm = kInfinity;
  EXPECT_THAT(error_message([&] { optics_of(params); }), HasSubstr("infinitely distant"));
}

TEST(ScreenEyes, microlenses_refuse_a_height) {
  RenderParams params;
  params.optics.kind = OpticsKind::kMicrolens, params.optics.eye_height = EyeHeight{20.0f, false};
  params.optics.viewing_distance_mm = 400.0f;
  EXPECT_THAT(error_message([&] { optics_of(params); }), HasSubstr("eye-height"));
}

TEST(ScreenEyes, heights_are_lengths_or_angles) {
  EXPECT_EQ(write_eye_height(read_eye_height("-150.5", "w")), "-150.5");
  EXPECT_EQ(write_eye_height(read_eye_height("30deg", "w")), "30deg");
  for (const char* text : {"", "deg", "90deg", "30 deg", "1e9", "nan", "up"})
    EXPECT_THAT(error_message([&] { read_eye_height(text, "w"); }), HasSubstr("30deg")) << text;
}

}  // namespace
}  // namespace lippmann

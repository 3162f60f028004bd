// Rays of a plenoptic camera by values worked out by hand: through a microlens, the main lens, and out by the lens equation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lippmann/optics/viewing.hpp"
#include "optics/optics_json.hpp"
#include "optics/optics_kind.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

/// f = 100 and Zf = 300: s = 150, and the plane z = 0 is seen at twice the sensor's scale. t/b = 100. Ten pixels of 0.0101 mm
/// below each of 10 x 10 lenses of 0.1 mm, whose images are 0.1 (1 + 1.5 / 150) = 0.101 mm apart.
PlenopticCamera some_camera() {
  return {.lens_pitch_mm = 0.1f,
          .gap_mm = 1.5f,
          .offset_mm = {0.05f, 0.05f},
          .focal_length_mm = 100.0f,
          .f_number = 10.0f,
          .distance_mm = 300.0f};
}

Optics optics_of(const PlenopticCamera& camera) { return {.panel = {100, 100, 0.0101f}, .model = camera}; }

/// Returns the place of a pixel's ray, Z in front of the main lens.
Vec2d place_at(const Optics& optics, Vec2f pixel, double z) {
  const Ray ray = ray_of_pixel(optics, pixel);
  const double distance = static_cast<double>(std::get<PlenopticCamera>(optics.model).distance_mm);
  const Vec3d from(ray.origin), to(ray.direction);
  return Vec2d(from) + Vec2d(to) * ((distance - z - from.z) / to.z);
}

void expect_at(Vec2d place, Vec2d expected, double tolerance = 1e-4) {
  EXPECT_NEAR(place.x, expected.x, tolerance);
  EXPECT_NEAR(place.y, expected.y, tolerance);
}

/// Pixel (57.5, 42.5) lies 2.5 pixels right and above the middle of the image at (55, 45) below the lens at (0.05, 0.05): the
/// ray meets the main lens at 2.5 x 0.0101 x 100 = 2.525 mm, and the plane in focus at twice the lens's place.
TEST(Plenoptic, rays_cross_main_lens_and_focus) {
  const Optics optics = optics_of(some_camera());
  expect_at(place_at(optics, {57.5f, 42.5f}, 0.0), {2.525, 2.525});
  expect_at(place_at(optics, {57.5f, 42.5f}, 300.0), {0.1, 0.1});
  // Twice as far, it has crossed over: 2.525 (1 - 600 / 300) + 0.05 x 600 / 150.
  expect_at(place_at(optics, {57.5f, 42.5f}, 600.0), {-2.325, -2.325});
}

/// The lens equation: what is 151.5 mm behind the lens, as the sensor, is an image of what is 151.5 x 100 / 51.5 in front of
/// it, seen from the middle of the lens in the direction of the pixel, 7.5 pixels beside the axis.
TEST(Plenoptic, rays_meet_the_image_of_their_pixel) {
  const double z = 151.5 * 100.0 / 51.5, x = 7.5 * 0.0101 * z / 151.5;
  expect_at(place_at(optics_of(some_camera()), {57.5f, 42.5f}, z), {x, x});
}

/// |A| = 3.571 mm at that pixel: f / 2N is 3.125 mm for N = 16 and 4.167 mm for N = 12.
TEST(Plenoptic, rays_beside_the_aperture_are_blocked) {
  PlenopticCamera camera = some_camera();
  camera.f_number = 16.0f;
  EXPECT_TRUE(is_blocked(optics_of(camera), {57.5f, 42.5f}));
  EXPECT_FALSE(is_blocked(optics_of(camera), {55.5f, 45.5f}));
  camera.f_number = 12.0f;
  EXPECT_FALSE(is_blocked(optics_of(camera), {57.5f, 42.5f}));
  EXPECT_FALSE(is_blocked({.panel = {8, 8, 0.1f}, .model = SingleView{}}, {0.5f, 0.5f}));
}

/// The f-number of the microlenses is f b / (t cell) = 100 / (100 x 0.101): discs of 10 pixels touch, and hold 80 of 100 pixel
/// centres.
TEST(Plenoptic, equal_f_numbers_fill_the_cells) {
  PlenopticCamera camera = some_camera();
  camera.f_number = 100.0f / 10.1f;
  const Optics optics = optics_of(camera);
  int lit = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) lit += !is_blocked(optics, Vec2f(x, y) + 0.5f);
  EXPECT_EQ(lit, 100 * 80);
}

/// A point at (X, Z) is at l = s (X/Z + A (1/Zf - 1/Z)) in the view through A.
TEST(Plenoptic, parallax_is_that_of_thin_lenses) {
  PlenopticCamera camera = some_camera();
  camera.distance_mm = 2000.0f;
  const Optics optics = optics_of(camera);
  const double s = 100.0 * 2000.0 / 1900.0, f = 1.0 / 2000.0;
  for (const Vec2f pixel : {Vec2f(3.5f, 91.5f), Vec2f(48.2f, 20.7f), Vec2f(77.5f, 33.3f)}) {
    const Vec2d lens = place_at(optics, pixel, 2000.0) * s / 2000.0, eye = place_at(optics, pixel, 0.0);
    for (const double z : {500.0, 1500.0, 2000.0, 4000.0, 1e5})
      expect_at(s * (place_at(optics, pixel, z) / z + eye * (f - 1.0 / z)), lens, 2e-5);
  }
}

/// In a camera 2.0 the main lens's image of a point at 2 I lies at I, e = 3 mm before the array. A lens at l shows it at
/// l + (l - I) b/e: images under neighbouring lenses are 0.1 x 1.5 / 3 mm farther apart than the lenses.
TEST(Plenoptic, focused_camera_repeats_points_below_lenses) {
  PlenopticCamera camera = some_camera();
  camera.array_shift_mm = 3.0f;
  const Optics optics = optics_of(camera);
  for (const double image : {0.05, 0.08}) {
    for (const double lens : {0.05, 0.15}) {
      const double q = lens + (lens - image) * 0.5;
      const Vec2f pixel(static_cast<float>(50.0 + q / 0.0101), static_cast<float>(50.0 - q / 0.0101));
      expect_at(place_at(optics, pixel, 300.0), {2.0 * image, 2.0 * image}, 5e-4);
    }
  }
}

/// The rays of the middles of lens images run through the middle of the main lens.
TEST(Plenoptic, lens_images_lie_below_lenses) {
  for (const LensPacking packing : {LensPacking::kSquare, LensPacking::kHexagonal}) {
    PlenopticCamera camera = some_camera();
    camera.packing = packing;
    const Optics optics = optics_of(camera);
    const SensorLenses lenses = *sensor_lenses(optics);
    EXPECT_NEAR(lenses.pitch_px, 10.0, 1e-5);
    EXPECT_NEAR(lenses.row_pitch_px, packing == LensPacking::kSquare ? 10.0 : 8.660254, 1e-5);
    for (int row = -2; row <= 3; ++row)
      for (int column = -2; column <= 3; ++column) {
        const bool shifted = packing == LensPacking::kHexagonal && row % 2 != 0;
        const Vec2d at =
            lenses.centre_px + Vec2d(column + (shifted ? 0.5 : 0.0), row) * Vec2d(lenses.pitch_px, lenses.row_pitch_px);
        expect_at(place_at(optics, Vec2f(at), 0.0), {0.0, 0.0}, 1e-3);
      }
  }
  EXPECT_FALSE(sensor_lenses({.panel = {8, 8, 0.1f}, .model = MicrolensArray{}}));
}

/// With one pixel below each lens, all rays run through the middle of the main lens.
TEST(Plenoptic, one_pixel_per_lens_is_a_pinhole_camera) {
  PlenopticCamera camera = some_camera();
  camera.lens_pitch_mm = 0.0101f / 1.01f, camera.offset_mm = Vec2f(0.5f * camera.lens_pitch_mm);
  const Optics optics = optics_of(camera);
  const Optics pinhole{.panel = {100, 100, 0.0101f * 300.0f / 151.5f}, .model = SingleView{300.0f}};
  EXPECT_NEAR(window_size_mm(optics).x, window_size_mm(pinhole).x, 1e-4f);
  for (const Vec2f pixel : {Vec2f(0.5f, 0.5f), Vec2f(50.5f, 99.5f), Vec2f(33.5f, 71.5f)}) {
    const Ray a = ray_of_pixel(optics, pixel), b = ray_of_pixel(pinhole, pixel);
    EXPECT_LT(glm::distance(a.origin, b.origin), 1e-3f);
    EXPECT_LT(glm::distance(a.direction, b.direction), 1e-5f);
  }
}

TEST(Plenoptic, json_gives_the_same_rays) {
  PlenopticCamera camera = some_camera();
  camera.packing = LensPacking::kHexagonal, camera.array_shift_mm = -2.0f;
  const Optics optics = optics_of(camera), back = optics_from_json(optics_json(optics), "report.json");
  EXPECT_EQ(ray_of_pixel(optics, {31.0f, 77.0f}).direction, ray_of_pixel(back, {31.0f, 77.0f}).direction);
  EXPECT_EQ(optics_json(optics)["kind"], "plenoptic");
}

TEST(Plenoptic, impossible_cameras_are_refused) {
  const auto complaint = [](const auto& change) {
    PlenopticCamera camera = some_camera();
    change(camera);
    return test::error_message([&] { validate(optics_of(camera)); });
  };
  EXPECT_NO_THROW(validate(optics_of(some_camera())));
  EXPECT_THAT(complaint([](PlenopticCamera& c) { c.distance_mm = 100.0f; }), HasSubstr("plenoptic.distance_mm"));
  EXPECT_THAT(complaint([](PlenopticCamera& c) { c.f_number = 0.0f; }), HasSubstr("plenoptic.f_number"));
  EXPECT_THAT(complaint([](PlenopticCamera& c) { c.array_shift_mm = -151.0f; }), HasSubstr("plenoptic.array_shift_mm"));
  EXPECT_THAT(complaint([](PlenopticCamera& c) { c.gap_mm = NAN; }), HasSubstr("plenoptic.gap_mm"));
  std::vector<Vec2f> pixels;
  EXPECT_THAT(test::error_message([&] {
                pixels_seeing(optics_of(some_camera()), {0, 0, 0}, pixels);
              }),
              HasSubstr("cannot be inverted"));
}

PlenopticCamera camera_of(const OpticsParams& params, float f_number = 0.0f) {
  const Panel panel{360, 240, 0.1f};
  return std::get<PlenopticCamera>(plenoptic_kind.make_model({params, panel, {360, 240, 10.0f}, 1000.0f, {}, 50.0f, f_number}));
}

/// The scene's camera sees what a pinhole 50 mm before the sensor sees.
TEST(Plenoptic, parameters_make_a_camera) {
  OpticsParams params;
  const PlenopticCamera matched = camera_of(params);
  EXPECT_EQ(matched.f_number, 2.0f);
  // b = 1 x 2 (1 + 50 / 1000) / (1 + 2 / 1000), s = 50 - b, f = 1 / (1 / s + 1 / 1000); and lens images touch: b = N s / f.
  EXPECT_NEAR(matched.gap_mm, 2.095808f, 1e-5f);
  EXPECT_NEAR(matched.focal_length_mm, 45.7143f, 1e-3f);
  EXPECT_NEAR(2.0f * (50.0f - matched.gap_mm) / matched.focal_length_mm, matched.gap_mm, 1e-5f);
  params.gap_mm = 1.0f;
  // s = 49, f = 46.711, and N = f b / s.
  EXPECT_NEAR(camera_of(params).focal_length_mm, 46.71115f, 1e-3f);
  EXPECT_NEAR(camera_of(params).f_number, 46.71115f / 49.0f, 1e-5f);
  EXPECT_EQ(camera_of(params, 4.0f).f_number, 4.0f);
  params.lens_focal_length_mm = 0.75f;  // 1/e = 1/0.75 - 1: e = 3
  EXPECT_NEAR(camera_of(params).array_shift_mm, 3.0f, 1e-5f);
  params.lens_focal_length_mm = 1.25f;
  EXPECT_NEAR(camera_of(params).array_shift_mm, -5.0f, 1e-5f);
  params.focal_length_mm = 100.0f;
  EXPECT_EQ(camera_of(params).focal_length_mm, 100.0f);
}

TEST(Plenoptic, parameters_without_a_camera_are_refused) {
  OpticsParams params;
  params.focal_length_mm = 1000.0f;
  EXPECT_THAT(test::error_message([&] { camera_of(params); }), HasSubstr("focal-length"));
  params = {};
  params.gap_mm = 60.0f;
  EXPECT_THAT(test::error_message([&] { camera_of(params); }), HasSubstr("gap"));
  params.gap_mm = 0.1f;  // 46 / 8 mm wide, seen 0.1 / 50 times as large: an eighth of a pixel
  EXPECT_THAT(test::error_message([&] { camera_of(params, 8.0f); }), HasSubstr("f-number: is 8: the image below each"));
}

}  // namespace
}  // namespace lippmann

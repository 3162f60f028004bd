// Compares rays from a pixel through a microlens and the main lens with values computed by hand.
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

/// Focal length f = 100 mm, focused at Zf = 300 mm: the array is s = 1 / (1 / 100 - 1 / 300) = 150 mm behind the main
/// lens. The plane in focus, z = 0, is Zf / s = 2 times as large as its image on the array. The gap to the sensor is b
/// = 1.5 mm, so s / b = 100. Lenses of 0.1 mm have images 0.1 (1 + 1.5 / 150) = 0.101 mm apart, which is 10 pixels of
/// 0.0101 mm.
PlenopticCamera some_camera() {
  return {.lens_pitch_mm = 0.1f,
          .gap_mm = 1.5f,
          .offset_mm = {0.05f, 0.05f},
          .focal_length_mm = 100.0f,
          .f_number = 10.0f,
          .distance_mm = 300.0f};
}

Optics optics_of(const PlenopticCamera& camera) { return {.panel = {100, 100, 0.0101f}, .model = camera}; }

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

/// The image of the lens at l = (0.05, 0.05) mm is centred at pixel (55, 45). Pixel (57.5, 42.5) is 2.5 pixels of
/// 0.0101 mm to the right and above, so its ray meets the main lens at A = 2.5 * 0.0101 * 150 / 1.5 = 2.525 mm in x and
/// y, and the plane in focus at 2 l = 0.1 mm.
TEST(Plenoptic, rays_cross_main_lens_and_focus) {
  const Optics optics = optics_of(some_camera());
  expect_at(place_at(optics, {57.5f, 42.5f}, 0.0), {2.525, 2.525});
  expect_at(place_at(optics, {57.5f, 42.5f}, 300.0), {0.1, 0.1});
  // At twice the focus distance: A (1 - 600 / 300) + l * 600 / 150 = -2.525 + 0.05 * 4 = -2.325 mm.
  expect_at(place_at(optics, {57.5f, 42.5f}, 600.0), {-2.325, -2.325});
}

/// The sensor, 151.5 mm behind the main lens, is the image of a plane 151.5 * 100 / 51.5 mm in front of it. The ray of
/// a pixel 7.5 pixels off the axis must pass through the point whose image it is.
TEST(Plenoptic, rays_meet_the_image_of_their_pixel) {
  const double z = 151.5 * 100.0 / 51.5, x = 7.5 * 0.0101 * z / 151.5;
  expect_at(place_at(optics_of(some_camera()), {57.5f, 42.5f}, z), {x, x});
}

/// The ray of pixel (57.5, 42.5) meets the main lens |A| = 2.525 sqrt(2) = 3.571 mm from the axis. The aperture's
/// radius is f / (2 N): 3.125 mm for the f-number N = 16 and 4.167 mm for 12.
TEST(Plenoptic, rays_beside_the_aperture_are_blocked) {
  PlenopticCamera camera = some_camera();
  camera.f_number = 16.0f;
  EXPECT_TRUE(is_blocked(optics_of(camera), {57.5f, 42.5f}));
  EXPECT_FALSE(is_blocked(optics_of(camera), {55.5f, 45.5f}));
  camera.f_number = 12.0f;
  EXPECT_FALSE(is_blocked(optics_of(camera), {57.5f, 42.5f}));
  EXPECT_FALSE(is_blocked({.panel = {8, 8, 0.1f}, .model = SingleView{}}, {0.5f, 0.5f}));
}

/// Images of the aperture below neighbouring lenses touch at the f-number f b / (s c) = 100 / (100 * 0.101), with s / b
/// = 100 and images c = 0.101 mm apart. An image is a disc of 10 pixels, which contains 80 of 100 pixel centres.
TEST(Plenoptic, equal_f_numbers_fill_the_cells) {
  PlenopticCamera camera = some_camera();
  camera.f_number = 100.0f / 10.1f;
  const Optics optics = optics_of(camera);
  int lit = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) lit += !is_blocked(optics, Vec2f(x, y) + 0.5f);
  EXPECT_EQ(lit, 100 * 80);
}

/// Through the point A of the main lens, a point X at distance Z appears on the lens array at l = s (X / Z + A (1 / Zf
/// - 1 / Z)), with the array at s and the focus at Zf.
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

/// The main lens of a focused plenoptic camera forms the image I of a point in the plane z = 0, e = 3 mm in front of
/// the array. The lens at l projects I to the sensor position l + (l - I) b / e, with the gap b = 1.5 mm.
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
              HasSubstr("cannot be computed for these optics"));
}

PlenopticCamera camera_of(const OpticsParams& params, float f_number = 0.0f) {
  const Panel panel{360, 240, 0.1f};
  return std::get<PlenopticCamera>(plenoptic_kind.make_model({params, panel, {360, 240, 10.0f}, 1000.0f, {}, 50.0f, f_number}));
}

/// The camera has the field of view of the scene's camera, a pinhole 50 mm in front of the sensor.
TEST(Plenoptic, parameters_make_a_camera) {
  OpticsParams params;
  const PlenopticCamera matched = camera_of(params);
  EXPECT_EQ(matched.f_number, 2.0f);
  // Cells are c = 1 mm wide, the f-number is N = 2, and the focus is at 1000 mm. Gap: b = c N (1 + 50 / 1000) / (1 + c
  // N / 1000) = 2.0958 mm. Array: s = 50 mm - b. Focal length: f = 1 / (1 / s + 1 / 1000). Images below neighbouring
  // lenses then touch: b = N s c / f.
  EXPECT_NEAR(matched.gap_mm, 2.095808f, 1e-5f);
  EXPECT_NEAR(matched.focal_length_mm, 45.7143f, 1e-3f);
  EXPECT_NEAR(2.0f * (50.0f - matched.gap_mm) / matched.focal_length_mm, matched.gap_mm, 1e-5f);
  params.gap_mm = 1.0f;
  // With a gap of b = 1 mm, the array is at s = 49 mm, the focal length is f = 46.711 mm, and the f-number is f b / (s
  // c) with cells of c = 1 mm.
  EXPECT_NEAR(camera_of(params).focal_length_mm, 46.71115f, 1e-3f);
  EXPECT_NEAR(camera_of(params).f_number, 46.71115f / 49.0f, 1e-5f);
  EXPECT_EQ(camera_of(params, 4.0f).f_number, 4.0f);
  // The array is shifted by e with 1 / e = 1 / 0.75 - 1 / gap, for microlenses of 0.75 mm and a gap of 1 mm.
  params.lens_focal_length_mm = 0.75f;
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
  // With a gap of 0.1 mm, the array is 49.9 mm behind the main lens, whose focal length is 47.5 mm. At f/8, the
  // aperture's image below a microlens is 47.5 / 8 * 0.1 / 49.9 = 0.012 mm wide: an eighth of a pixel.
  params.gap_mm = 0.1f;
  EXPECT_THAT(test::error_message([&] { camera_of(params, 8.0f); }), HasSubstr("f-number: is 8: the image below each"));
}

}  // namespace
}  // namespace lippmann

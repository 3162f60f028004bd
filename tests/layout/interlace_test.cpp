// Interlacing makes the native frame of a slanted panel from views.
#include "lippmann/layout/interlace.hpp"

#include <gmock/gmock.h>

#include <array>
#include <string>

#include "layout/light_fields.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/formats/convert.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

const ThreadPool& threads() {
  static const ThreadPool pool(2);
  return pool;
}

/// The lenses are 11.4 sub-pixels wide.
Display small_display() {
  Display display;
  display.name = "small";
  display.pixels = {60, 41};
  display.dpi = 100.0;
  display.calibration.pitch = 26.8, display.calibration.slope = -5.3, display.calibration.center = 0.37;
  return display;
}

TEST(Interlace, quilt_positions_match_hand_calculation) {
  // The quilt for the Portrait's 1536 x 2048 pixels has 8 x 6 tiles of 21 x 28 pixels. Each pixel of the quilt has its own
  // value.
  // A sub-pixel of pixel (i, j) with the value v shows the view floor(48 v). tests/display/slanted_panel_test.cpp derives v.
  // The view's tile is in column (view mod 8) and in row floor(view / 8), counted from the bottom.
  // The pixel in the tile is ((i + 1/2) 21 / 1536, (j + 1/2) 28 / 2048), rounded down.
  //   panel (i, j)        v         view  tile, from the top  in the tile  in the quilt
  //   (0, 0) red          0.893189  42    (2, 0)              (0, 0)       (42, 0)
  //   (0, 0) blue         0.787268  37    (5, 1)              (0, 0)       (105, 28)
  //   (1535, 0) blue      0.905266  43    (3, 0)              (20, 0)      (83, 0)
  //   (767, 1023) green   0.759376  36    (4, 1)              (10, 13)     (94, 41)
  //   (100, 2047) red     0.543830  26    (2, 2)              (1, 27)      (43, 83)
  //   (1535, 2047) blue   0.443986  21    (5, 3)              (20, 27)     (125, 111)
  const test::TempDir dir;
  Image16 quilt{168, 168, {}};
  for (int i = 0; i < 168 * 168; ++i)
    for (int color = 0; color < 3; ++color) quilt.rgb.push_back(static_cast<std::uint16_t>(i));
  write_picture(dir / "codes_qs8x6a0.75.png", quilt);
  ConvertParams params{.from = "quilt", .to = "native", .options = {}, .crop = {}, .keep = {}};
  params.options.display = load_display("portrait");
  convert(dir / "codes_qs8x6a0.75.png", dir / "panel.png", params);
  const auto frame = std::get<Image16>(read_picture(dir / "panel.png"));
  ASSERT_EQ(Vec2i(frame.width, frame.height), Vec2i(1536, 2048));
  const auto code = [&](int i, int j, int color) { return frame.rgb[static_cast<std::size_t>(3 * (j * 1536 + i) + color)]; };
  EXPECT_EQ(code(0, 0, 0), 0 * 168 + 42);
  EXPECT_EQ(code(0, 0, 2), 28 * 168 + 105);
  EXPECT_EQ(code(1535, 0, 2), 0 * 168 + 83);
  EXPECT_EQ(code(767, 1023, 1), 41 * 168 + 94);
  EXPECT_EQ(code(100, 2047, 0), 83 * 168 + 43);
  EXPECT_EQ(code(1535, 2047, 2), 111 * 168 + 125);
}

TEST(Interlace, nearest_round_trip_is_exact) {
  // A sample of a view covers 6 x 5 pixels, so 18 sub-pixels in a row. A lens is only 11.4 sub-pixels wide, so every
  // sample is shown.
  for (const bool words : {false, true}) {
    const LightField field = test::numbered_field({2, 1}, {10, 8}, words);
    const Picture frame = interlace(field, small_display(), {}, threads());
    EXPECT_TRUE(test::same_samples(deinterlace(frame, small_display(), 2, {10, 8}, "frame", threads()).stack, field.stack));
  }
}

TEST(Interlace, deinterlaced_frame_interlaces_to_itself) {
  // With 11 views, the frame has too few sub-pixels to show all samples. Interlacing the extracted views must still
  // restore the frame.
  const LightField field = test::numbered_field({11, 1}, {31, 29});
  for (const Vec2i size : {Vec2i(31, 29), Vec2i(60, 41), Vec2i(90, 77)}) {
    const LightField same = test::numbered_field({11, 1}, size);
    const Picture frame = interlace(size.x == 31 ? field : same, small_display(), {}, threads());
    const LightField apart = deinterlace(frame, small_display(), 11, size, "frame", threads());
    EXPECT_TRUE(test::same_samples(interlace(apart, small_display(), {}, threads()), frame)) << size.x;
  }
}

LightField steps(int count, Vec2i size) {
  LightField field = test::numbered_field({count, 1}, size, true);
  auto& rgb = std::get<Image16>(field.stack).rgb;
  const std::size_t per_view = rgb.size() / static_cast<std::size_t>(count);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint16_t>(i / per_view * 1000);
  return field;
}

TEST(Interlace, linear_filter_interpolates_between_views) {
  // View k has the code 1000 k. Interpolation at the view coordinate v gives 1000 (48 v - 1/2) for 48 views. v =
  // 0.893189: 42373; v = 0.759376: 35950; v = 0.443986: 20811.
  const auto frame =
      std::get<Image16>(interlace(steps(48, {3, 4}), load_display("portrait"), {ViewFilter::kLinear, 0.5}, threads()));
  const auto code = [&](int i, int j, int color) { return frame.rgb[static_cast<std::size_t>(3 * (j * 1536 + i) + color)]; };
  EXPECT_NEAR(code(0, 0, 0), 42373, 1);
  EXPECT_NEAR(code(767, 1023, 1), 35950, 1);
  EXPECT_NEAR(code(1535, 2047, 2), 20811, 1);
}

TEST(Interlace, gaussian_filter_weighs_views_by_their_distance) {
  // The sub-pixel is at 48 v - 1/2 = 42.37307 among the 48 views. The Gaussian has a sigma of 1/2 view. Views 41 to 44
  // lie within 3.5 sigma, at distances d = -1.37307, -0.37307, 0.62693 and 1.62693. Their weights exp(-2 d^2) are
  // 0.023037, 0.757022, 0.455626 and 0.005023, with the sum 1.240708. The weighted mean is 41 + (0.757022 + 2 *
  // 0.455626 + 3 * 0.005023) / 1.240708 = 42.35676.
  const auto frame =
      std::get<Image16>(interlace(steps(48, {3, 4}), load_display("portrait"), {ViewFilter::kGaussian, 0.5}, threads()));
  EXPECT_NEAR(frame.rgb[0], 42357, 2);
}

TEST(Interlace, linear_filter_is_bilinear_within_a_view) {
  // Two samples, 0 and 6000, cover 60 pixels, so their centres are at 15 and 45 pixels. The centre of pixel 22 is at
  // 22.5: (22.5 - 15) / 30 * 6000 = 1500.
  LightField field = test::numbered_field({1, 1}, {2, 1}, true);
  std::get<Image16>(field.stack).rgb = {0, 0, 0, 6000, 6000, 6000};
  const auto frame = std::get<Image16>(interlace(field, small_display(), {ViewFilter::kLinear, 0.5}, threads()));
  EXPECT_EQ(frame.rgb[3 * 22], 1500);
  EXPECT_EQ(frame.rgb[3 * 3], 0);
  EXPECT_EQ(frame.rgb[3 * 57], 6000);
}

TEST(Interlace, native_rays_match_interlaced_views) {
  // A sub-pixel's ray must meet the part of the view cone that belongs to the view shown by the sub-pixel.
  const Display display = load_display("looking-glass-16-portrait");
  const Optics optics = native_optics(display);
  const auto& panel = std::get<SlantedPanel>(optics.model);
  const auto frame = std::get<Image16>(interlace(steps(48, {3, 4}), display, {}, threads()));
  for (int j = 0; j < display.pixels.y; j += 97)
    for (int i = 0; i < display.pixels.x; i += 31)
      for (int color = 0; color < 3; ++color) {
        const Ray ray = ray_of_pixel(optics, {3 * i + color + 0.5f, j + 0.5f});
        const double eye = ray.origin.x + (panel.distance_mm - ray.origin.z) / ray.direction.z * ray.direction.x;
        const double v = 48 * (0.5 + std::atan(eye / panel.distance_mm) / panel.view_cone);
        const double view = frame.rgb[static_cast<std::size_t>(3 * (j * display.pixels.x + i) + color)] / 1000.0;
        EXPECT_GE(v, view - 1e-4);  // 1e-4 of a view is 2e-6 of the cone, near single precision
        EXPECT_LE(v, view + 1 + 1e-4);
      }
}

// Cees van Berkel, "Image preparation for 3D-LCD", Proc. SPIE 3639, 1999: sub-pixel k of row l, counted from the top
// left, shows the view N / X ((k + k_off - 3 l tan a) mod X) for N views, lenses of X sub-pixels and the slant a. With
// N = 9, X = 9/2 and tan a = 1/6, this is (2 k - l) mod 9. The paper counts views from the right.
TEST(Interlace, nine_view_television_matches_published_mask) {
  const Display display = load_display(std::string(LIPPMANN_SOURCE) + "/examples/nine-view-television.toml");
  const auto frame = std::get<Image16>(interlace(steps(9, {4, 3}), display, {}, threads()));
  ASSERT_EQ(Vec2i(frame.width, frame.height), Vec2i(1920, 1080));
  std::array<int, 9> counts{};
  for (int l = 0; l < 1080; ++l)
    for (int k = 0; k < 3 * 1920; ++k) {
      const int mask = ((2 * k - l) % 9 + 9) % 9, view = 8 - mask;
      const int shown = frame.rgb[static_cast<std::size_t>(l * 3 * 1920 + k)] / 1000;
      ASSERT_EQ(shown, view) << "sub-pixel " << k << " of row " << l;
      ++counts[static_cast<std::size_t>(view)];
    }
  EXPECT_THAT(counts, testing::Each(1920 * 3 * 1080 / 9));
}

TEST(Interlace, any_number_of_threads_gives_the_same) {
  const LightField field = test::numbered_field({11, 1}, {31, 29});
  const ThreadPool one(1), five(5);
  for (const ViewFilter filter : {ViewFilter::kNearest, ViewFilter::kLinear, ViewFilter::kGaussian}) {
    const Picture frame = interlace(field, small_display(), {filter, 0.5}, one);
    EXPECT_TRUE(test::same_samples(frame, interlace(field, small_display(), {filter, 0.5}, five)));
    EXPECT_TRUE(test::same_samples(deinterlace(frame, small_display(), 11, {31, 29}, "frame", one).stack,
                                   deinterlace(frame, small_display(), 11, {31, 29}, "frame", five).stack));
  }
}

TEST(BadInterlacing, says_what_would_be_accepted) {
  const LightField row = test::numbered_field({4, 1}, {3, 2}), grid = test::numbered_field({2, 2}, {3, 2});
  const Display sheet = load_display("lenticular-60lpi-720dpi");
  EXPECT_THAT(test::error_message([&] { interlace(row, sheet, {}, threads()); }), HasSubstr("a slanted panel"));
  EXPECT_THAT(test::error_message([&] {
                deinterlace(row.stack, sheet, 4, {3, 2}, "a.png", threads());
              }),
              HasSubstr("a slanted panel"));
  EXPECT_THAT(test::error_message([&] { interlace(grid, small_display(), {}, threads()); }), HasSubstr("2x2"));
  EXPECT_THAT(test::error_message([&] {
                deinterlace(row.stack, small_display(), 4, {3, 2}, "a.png", threads());
              }),
              HasSubstr("60x41"));
  const ConvertParams no_display{.from = "native", .to = "views", .options = {}, .crop = {}, .keep = {}};
  EXPECT_THAT(test::error_message([&] { convert("frame.png", "views", no_display); }), testing::StartsWith("display"));
}

}  // namespace
}  // namespace lippmann

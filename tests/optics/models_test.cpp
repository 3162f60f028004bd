#include <gtest/gtest.h>

#include <cmath>

#include "optics/ray_generator.hpp"
#include "random_optics.hpp"
#include "support/near.hpp"

namespace lippmann {
namespace {

using test::at_depth;
using test::OpticsSampler;

// Tolerances. In single precision, positions of a few hundred mm have errors of about 1e-5 mm, and slopes near 1 have
// errors of about 1e-6.
constexpr float kPositionMm = 1e-4f, kSlope = 2e-6f;

Vec2f slope(const Ray& ray) { return {ray.direction.x / ray.direction.z, ray.direction.y / ray.direction.z}; }

using test::expect_near;

TEST(Lenticular, first_pixel_of_a_lens_goes_right) {
  // 8 pixels of 0.125 mm lie below a lens of 1 mm, with a gap of 2 mm. Pixel (256, 256) of 512 x 512 is at x = 0.0625,
  // y = -0.0625, below the lens at x = 0.5. Its slope is (0.5 - 0.0625) / 2 = 0.21875. At 8 mm, x = 0.5 + 8 * 0.21875 =
  // 2.25.
  const Optics optics{.panel = {}, .model = LenticularSheet{}, .z_front_mm = 8.0f};
  const Ray ray = ray_of_pixel(optics, {256.5f, 256.5f});
  EXPECT_EQ(ray.origin, Vec3f(2.25f, -0.0625f, 8.0f));
  EXPECT_NEAR(slope(ray).x, 0.21875f, kSlope);
  EXPECT_EQ(slope(ray).y, 0.0f);
  expect_near(at_depth(ray, 0.0f), {0.5f, -0.0625f, 0.0f}, kPositionMm);
}

TEST(Lenticular, cell_centres_converge_to_the_eye) {
  LenticularSheet sheet{.lens_pitch_mm = 1.0f / 1.004f, .gap_mm = 2.0f, .offset_mm = 0.5f / 1.004f};
  sheet.viewing_distance_mm = 500.0f, sheet.eye_height_mm = 20.0f;
  const Optics optics{.panel = {}, .model = sheet};
  EXPECT_EQ(whole_pixels_per_lens(optics), Vec2i(8, 1));
  // Eight pixels lie below a lens. The ray from the middle, between pixels 3 and 4, passes through the eye at (0, 20,
  // 500).
  for (int lens : {0, 7, 31, 32, 63})
    for (float row : {0.5f, 100.5f, 511.5f})
      expect_near(at_depth(ray_of_pixel(optics, {8 * lens + 4.0f, row}), 500.0f), {0.0f, 20.0f, 500.0f}, kPositionMm);
}

TEST(Lenticular, slanted_rows_converge_to_eye_height) {
  OpticsSampler random(11);
  for (int trial = 0; trial < 30; ++trial) {
    Optics optics = random.lenticular(true);
    auto& sheet = std::get<LenticularSheet>(optics.model);
    sheet.viewing_distance_mm = 400.0f;
    const Vec2f pixel(random.uniform(0, film_size(optics).x), random.uniform(0, optics.panel.height));
    EXPECT_NEAR(at_depth(ray_of_pixel(optics, pixel), 400.0f).y, sheet.eye_height_mm, kPositionMm);
    // The ray passes through a lens axis, so `lens` must be a whole number.
    const Vec3f p = at_depth(ray_of_pixel(optics, pixel), 0.0f);
    const float lens = (p.x * std::cos(sheet.slant) + p.y * std::sin(sheet.slant) - sheet.offset_mm) / sheet.lens_pitch_mm;
    // The tolerance is kPositionMm = 1e-4 mm divided by the smallest pitch, 0.1 mm.
    EXPECT_NEAR(lens, std::round(lens), 1e-3f);
  }
}

TEST(Lenticular, rays_of_one_view_are_parallel) {
  // Floats cannot represent the pixel width of 0.1 mm exactly. In spite of rounding, the cell below each lens must be 5
  // whole pixels wide.
  const Optics optics{.panel = {1000, 4, 0.1f},
                      .model = LenticularSheet{.lens_pitch_mm = 0.5f, .gap_mm = 1.0f, .offset_mm = 0.25f}};
  ASSERT_EQ(whole_pixels_per_lens(optics), Vec2i(5, 1));
  for (int view = 0; view < 5; ++view)
    for (int lens = 1; lens < 200; ++lens)
      EXPECT_EQ(ray_of_pixel(optics, {5 * lens + view + 0.5f, 0.5f}).direction,
                ray_of_pixel(optics, {view + 0.5f, 0.5f}).direction);
}

TEST(Lenticular, cells_are_half_open) {
  const Optics optics{.panel = {1000, 4, 0.1f},
                      .model = LenticularSheet{.lens_pitch_mm = 0.5f, .gap_mm = 1.0f, .offset_mm = 0.25f}};
  for (int lens = 0; lens < 200; ++lens) {
    const float edge = 5.0f * lens;
    const float from_centre = (edge - 500.0f) * 0.1f + 0.25f;
    EXPECT_NEAR(at_depth(ray_of_pixel(optics, {edge, 0.5f}), 0.0f).x, from_centre, kPositionMm);
    EXPECT_NEAR(at_depth(ray_of_pixel(optics, {std::nextafter(edge + 5.0f, 0.0f), 0.5f}), 0.0f).x, from_centre, kPositionMm);
  }
}

TEST(Lenticular, one_lens_is_two_pinholes) {
  // A single lens covers the panel. Horizontally, all rays pass through the lens centre, `gap` in front of the panel;
  // vertically, through the eye.
  for (const float viewing_distance : {300.0f, 1000.0f}) {
    const Panel panel{80, 60, 0.1f};
    const float gap = 12.0f;
    const LenticularSheet sheet{.lens_pitch_mm = 8.0f / (1.0f + gap / viewing_distance),
                                .gap_mm = gap,
                                .offset_mm = 0.0f,
                                .viewing_distance_mm = viewing_distance};
    const Optics optics{.panel = panel, .model = sheet};
    const Optics across{.panel = panel, .model = SingleView{gap}},
        along{.panel = panel, .model = SingleView{viewing_distance + gap}};
    ASSERT_EQ(whole_pixels_per_lens(optics), Vec2i(80, 1));
    OpticsSampler random(12);
    for (int sample = 0; sample < 50; ++sample) {
      const Vec2f pixel(random.uniform(0, 80), random.uniform(0, 60));
      const Ray ray = ray_of_pixel(optics, pixel);
      // Horizontally, the ray has the slope of a pinhole at the lens; vertically, the slope of a pinhole at the viewer.
      EXPECT_NEAR(slope(ray).x, slope(ray_of_pixel(across, pixel)).x, kSlope);
      EXPECT_NEAR(slope(ray).y, slope(ray_of_pixel(along, pixel)).y, kSlope);
      EXPECT_NEAR(at_depth(ray, 0.0f).x, 0.0f, kPositionMm);
      EXPECT_NEAR(at_depth(ray, viewing_distance).y, 0.0f, kPositionMm);
    }
  }
}

TEST(Microlens, corner_pixel_goes_through_lens_centre) {
  // Pixel (256, 255) is at x = y = 0.0625, below the lens at (0.5, 0.5). With a gap of 2 mm, both slopes are (0.5 -
  // 0.0625) / 2 = 0.21875.
  const Optics optics{.panel = {}, .model = MicrolensArray{}, .z_front_mm = 8.0f};
  const Ray ray = ray_of_pixel(optics, {256.5f, 255.5f});
  EXPECT_EQ(ray.origin, Vec3f(2.25f, 2.25f, 8.0f));
  EXPECT_NEAR(slope(ray).x, 0.21875f, kSlope);
  EXPECT_NEAR(slope(ray).y, 0.21875f, kSlope);
}

TEST(Microlens, one_near_lens_is_a_pinhole) {
  const Panel panel{64, 64, 0.1f};
  const float gap = 9.0f, viewing_distance = 450.0f;
  const MicrolensArray array{.packing = LensPacking::kSquare,
                             .lens_pitch_mm = 6.4f / (1.0f + gap / viewing_distance),
                             .gap_mm = gap,
                             .offset_mm = {0.0f, 0.0f},
                             .viewing_distance_mm = viewing_distance};
  const Optics optics{.panel = panel, .model = array}, pinhole{.panel = panel, .model = SingleView{gap}};
  ASSERT_EQ(whole_pixels_per_lens(optics), Vec2i(64, 64));
  OpticsSampler random(13);
  for (int sample = 0; sample < 100; ++sample) {
    const Vec2f pixel(random.uniform(0, 64), random.uniform(0, 64));
    const Ray lens = ray_of_pixel(optics, pixel), eye = ray_of_pixel(pinhole, pixel);
    expect_near(lens.direction, eye.direction, kSlope);
    // The pinhole is at z = `gap`, and the lens at z = 0, so the comparison shifts points by `gap`.
    expect_near(at_depth(lens, -20.0f), at_depth(eye, gap - 20.0f) - Vec3f(0, 0, gap), kPositionMm);
  }
}

TEST(Microlens, hexagonal_rows_are_shifted_and_closer) {
  // With a pitch of 1 mm, the neighbours of lens (0, 0) above and below are at (1/2, +-sqrt(3) / 2).
  const MicrolensArray array{
      .packing = LensPacking::kHexagonal, .lens_pitch_mm = 1.0f, .gap_mm = 2.0f, .offset_mm = {0.0f, 0.0f}};
  const Optics optics{.panel = {128, 128, 0.0625f}, .model = array};
  const auto lens_of = [&](float x, float y) {
    return at_depth(ray_of_pixel(optics, {64 + x / 0.0625f, 64 - y / 0.0625f}), 0.0f);
  };
  const float row = std::sqrt(0.75f);
  expect_near(lens_of(0.05f, -0.08f), {0, 0, 0}, kPositionMm);
  expect_near(lens_of(0.4f, 0.8f), {0.5f, row, 0}, kPositionMm);
  expect_near(lens_of(-0.4f, -0.8f), {-0.5f, -row, 0}, kPositionMm);
  expect_near(lens_of(0.02f, 1.7f), {0, 2 * row, 0}, kPositionMm);
  // The upper corner of a hexagon is 1 / sqrt(3) = 0.577 above the lens centre.
  expect_near(lens_of(0.0f, 0.56f), {0, 0, 0}, kPositionMm);
  expect_near(lens_of(0.02f, 0.59f), {0.5f, row, 0}, kPositionMm);
  EXPECT_EQ(whole_pixels_per_lens(optics), Vec2i(0, 0));
}

TEST(Microlens, hexagonal_offset_shifts_the_lattice) {
  MicrolensArray array{.packing = LensPacking::kHexagonal, .lens_pitch_mm = 1.0f, .gap_mm = 2.0f, .offset_mm = {0.0f, 0.0f}};
  // The offset moves row 0 up by 3 rows, so the row at y = 0 becomes an odd row, which is shifted by half a pitch.
  array.offset_mm = {0.0f, 3.0f * std::sqrt(0.75f)};
  const Optics optics{.panel = {128, 128, 0.0625f}, .model = array};
  expect_near(at_depth(ray_of_pixel(optics, {64 + 0.4f / 0.0625f, 64.0f}), 0.0f), {0.5f, 0.0f, 0.0f}, kPositionMm);
}

TEST(SingleView, centre_of_the_first_pixel_by_hand) {
  // 4 x 2 pixels of 10 mm, with the eye at 100 mm. The ray of pixel (0, 0), at (-15, 5, 0), leaves the eye along (-15,
  // 5, -100).
  const Optics optics{.panel = {4, 2, 10.0f}, .model = SingleView{100.0f}};
  const Ray ray = ray_of_pixel(optics, {0.5f, 0.5f});
  EXPECT_EQ(ray.origin, Vec3f(0, 0, 100));
  expect_near(ray.direction, glm::normalize(Vec3f(-15, 5, -100)), 1e-6f);
}

TEST(SingleView, pixel_offset_shifts_right_and_down) {
  const Optics plain{.panel = {40, 20, 1.0f}, .model = SingleView{100.0f}};
  const Optics shifted{.panel = {40, 20, 1.0f}, .model = SingleView{100.0f, {0.5f, -0.25f}}};
  EXPECT_EQ(ray_of_pixel(shifted, {3.5f, 7.5f}).direction, ray_of_pixel(plain, {4.0f, 7.25f}).direction);
}

TEST(MultiView, one_view_quilt_is_a_single_view) {
  const Panel panel{50, 40, 0.3f};
  for (const bool ends : {false, true}) {
    const Optics quilt{.panel = panel, .model = MultiView{1, 1, 1.0f, ends, 250.0f}},
        single{.panel = panel, .model = SingleView{250.0f}};
    for (const Vec2f pixel : {Vec2f(0.5f, 0.5f), Vec2f(49.5f, 12.5f), Vec2f(25.0f, 39.5f)}) {
      EXPECT_EQ(ray_of_pixel(quilt, pixel).origin, ray_of_pixel(single, pixel).origin);
      EXPECT_EQ(ray_of_pixel(quilt, pixel).direction, ray_of_pixel(single, pixel).direction);
    }
  }
}

TEST(MultiView, view_is_off_axis) {
  const Optics quilt{.panel = {60, 20, 1.0f}, .model = MultiView{2, 1, radians(60.0f), false, 300.0f}};
  const Optics single{.panel = {30, 20, 1.0f}, .model = SingleView{300.0f}};
  const float eye = 300.0f * std::tan(radians(15.0f));
  for (const Vec2f pixel : {Vec2f(0.5f, 0.5f), Vec2f(29.5f, 3.5f), Vec2f(11.0f, 19.5f)}) {
    const Vec3f in_plane = at_depth(ray_of_pixel(single, pixel), 0.0f);
    const Ray left = ray_of_pixel(quilt, pixel), right = ray_of_pixel(quilt, pixel + Vec2f(30, 0));
    expect_near(left.origin, {-eye, 0, 300}, kPositionMm);
    expect_near(right.origin, {eye, 0, 300}, kPositionMm);
    expect_near(at_depth(left, 0.0f), in_plane, kPositionMm);
    expect_near(at_depth(right, 0.0f), in_plane, kPositionMm);
  }
}

TEST(MultiView, pixels_may_be_higher_than_wide) {
  // Pixels of 1 x 1.5 mm: the top edge of a tile of 10 x 10 pixels is 7.5 mm above its centre.
  const Optics quilt{.panel = {20, 20, 1.0f},
                     .model = MultiView{.columns = 2, .rows = 2, .distance_mm = 300.0f, .pixel_height = 1.5f}};
  expect_near(at_depth(ray_of_pixel(quilt, {10.0f, 0.0f}), 0.0f), {-5.0f, 7.5f, 0.0f}, kPositionMm);
  expect_near(at_depth(ray_of_pixel(quilt, {14.0f, 16.0f}), 0.0f), {-1.0f, -1.5f, 0.0f}, kPositionMm);
}

TEST(MultiView, cone_ends_place_the_outer_eyes) {
  const Optics quilt{.panel = {90, 20, 1.0f}, .model = MultiView{3, 1, radians(60.0f), true, 300.0f}};
  const float eye = 300.0f * std::tan(radians(30.0f));
  expect_near(ray_of_pixel(quilt, {15.0f, 10.0f}).origin, {-eye, 0, 300}, kPositionMm);
  expect_near(ray_of_pixel(quilt, {45.0f, 10.0f}).origin, {0, 0, 300}, kPositionMm);
  expect_near(ray_of_pixel(quilt, {75.0f, 10.0f}).origin, {eye, 0, 300}, kPositionMm);
}

TEST(MultiView, views_run_from_bottom_left_upwards) {
  const int columns = 8, rows = 6, tile = 10;
  const Optics quilt{.panel = {columns * tile, rows * tile, 1.0f},
                     .model = MultiView{columns, rows, radians(40.0f), false, 500.0f}};
  for (int v = 0; v < columns * rows; ++v) {
    const Vec2f centre((v % columns + 0.5f) * tile, (rows - 1 - v / columns + 0.5f) * tile);
    const float angle = radians(40.0f) * ((v + 0.5f) / 48.0f - 0.5f);
    EXPECT_NEAR(ray_of_pixel(quilt, centre).origin.x, 500.0f * std::tan(angle), kPositionMm) << "view " << v;
  }
}

TEST(MultiView, camera_grid_eyes_are_a_baseline_apart) {
  // 3 x 2 tiles with a baseline of 12 mm: columns of eyes at -12, 0 and 12 mm, rows at -6 (lower) and 6 mm.
  MultiView views{.columns = 3, .rows = 2, .distance_mm = 300.0f};
  views.baseline_mm = 12.0f;
  const Optics grid{.panel = {90, 40, 1.0f}, .model = views}, single{.panel = {30, 20, 1.0f}, .model = SingleView{300.0f}};
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 2; ++row) {
      const Vec2f pixel(7.5f, 3.5f);
      const Ray ray = ray_of_pixel(grid, pixel + Vec2f(30 * column, 20 * (1 - row)));
      expect_near(ray.origin, {12.0f * (column - 1), 12.0f * row - 6.0f, 300}, kPositionMm);
      expect_near(at_depth(ray, 0.0f), at_depth(ray_of_pixel(single, pixel), 0.0f), kPositionMm);
    }
}

TEST(MultiView, two_view_camera_grid_is_a_cone) {
  MultiView grid{.columns = 2, .rows = 1, .distance_mm = 300.0f};
  grid.baseline_mm = 2.0f * 300.0f * std::tan(radians(15.0f));
  const MultiView cone{2, 1, radians(60.0f), false, 300.0f};
  for (const Vec2f pixel : {Vec2f(0.5f, 0.5f), Vec2f(29.5f, 3.5f), Vec2f(41.0f, 19.5f)}) {
    const Ray a = ray_of_pixel({.panel = {60, 20, 1.0f}, .model = grid}, pixel);
    const Ray b = ray_of_pixel({.panel = {60, 20, 1.0f}, .model = cone}, pixel);
    expect_near(a.origin, b.origin, kPositionMm);
    expect_near(at_depth(a, -100.0f), at_depth(b, -100.0f), kPositionMm);
  }
}

TEST(MultiView, odd_sizes_leave_padding) {
  // 43 x 32 pixels hold 4 x 3 tiles of 10 x 10. The 3 columns at the right and the 2 rows at the top are padding.
  const Optics quilt{.panel = {43, 32, 1.0f}, .model = MultiView{4, 3, radians(40.0f), false, 500.0f}};
  std::vector<Vec2f> seeing;
  pixels_seeing(quilt, {0, 0, 0}, seeing);
  ASSERT_EQ(seeing.size(), 12u);
  EXPECT_EQ(seeing.front(), Vec2f(5.0f, 27.0f));
  EXPECT_EQ(seeing.back(), Vec2f(35.0f, 7.0f));
  expect_near(at_depth(ray_of_pixel(quilt, {35.0f, 7.0f}), 0.0f), {0, 0, 0}, kPositionMm);
}

TEST(MultiView, eyes_are_exact_over_the_widest_cone) {
  // The tangent multiplies an error of the angle by 1 / cos^2(angle), so the tolerance grows by this factor.
  for (const float cone : {0.1f, 1.0f, 2.0f, 3.0f}) {
    const Optics quilt{.panel = {400, 1, 1.0f}, .model = MultiView{400, 1, cone, true, 1.0f}};
    for (int v = 0; v < 400; ++v) {
      const double angle = static_cast<double>(cone) * (v / 399.0 - 0.5), expected = std::tan(angle);
      EXPECT_NEAR(ray_of_pixel(quilt, {v + 0.5f, 0.5f}).origin.x, expected, 1e-6 / std::pow(std::cos(angle), 2));
    }
  }
}

/// Returns where a sub-pixel's ray meets the plane of the eyes, from 0 to 1 across the view cone.
double view_of(const Optics& optics, Vec2f pixel) {
  const auto& slanted = std::get<SlantedPanel>(optics.model);
  const double eye = at_depth(ray_of_pixel(optics, pixel), slanted.distance_mm).x;
  return 0.5 + std::atan(eye / slanted.distance_mm) / slanted.view_cone;
}

TEST(SlantedPanel, sub_pixel_table_by_hand) {
  // The panel has 8 x 4 pixels and P = 2 lens periods across its width. The tilt T is -1/4 and the centre is 1/8.
  // Sub-pixel of pixel (i, j): x = (i + 1/6) / 8 for red, (i + 1/2) / 8 for green and (i + 5/6) / 8 for blue. y = (3.5 - j) /
  // 4, because row j counts from the top.
  // Phase: z = (x - y / 4) 2 - 1/8, so z grows by 1/12 from one sub-pixel to the next. View: v = 1 - fract(z).
  //   pixel (0, 0), y = 7/8:  red z = 1/24 - 7/16 - 1/8 = -25/48, v = 25/48; green v = 21/48; blue v = 17/48
  //   pixel (3, 0), y = 7/8:  green z = 3.5/4 - 7/16 - 1/8 = 15/48, v = 33/48
  //   pixel (1, 3), y = 1/8:  red z = (1 + 1/6) / 4 - 1/16 - 1/8 = 5/48, v = 43/48; green v = 39/48; blue v = 35/48
  //   pixel (7, 2), y = 3/8:  blue z = (7 + 5/6) / 4 - 3/16 - 1/8 = 79/48, v = 17/48
  SlantedPanel slanted{.periods = 2.0, .tilt = -0.25, .center = 0.125, .view_cone = 0.8f, .distance_mm = 300.0f};
  Optics optics{.panel = {8, 4, 0.3f}, .model = slanted};
  const struct {
    int i, j, color;
    double v;
  } table[] = {{0, 0, 0, 25 / 48.0}, {0, 0, 1, 21 / 48.0}, {0, 0, 2, 17 / 48.0}, {3, 0, 1, 33 / 48.0},
               {1, 3, 0, 43 / 48.0}, {1, 3, 1, 39 / 48.0}, {1, 3, 2, 35 / 48.0}, {7, 2, 2, 17 / 48.0}};
  // Rounding in single precision moves the eye by about 1e-5 mm. The view cone is 240 mm wide at the eyes, so the view
  // changes by less than 1e-6.
  constexpr double kView = 1e-6;
  for (const auto& [i, j, color, v] : table) {
    const Vec2f centre(3 * i + color + 0.5f, j + 0.5f);
    EXPECT_NEAR(view_of(optics, centre), v, kView) << i << " " << j << " " << color;
    expect_near(at_depth(ray_of_pixel(optics, centre), 0.0f), {(3 * i + color + 0.5f - 12) * 0.1f, (1.5f - j) * 0.3f, 0},
                kPositionMm);
  }
  slanted.inverted = false;
  optics.model = slanted;
  for (const auto& [i, j, color, v] : table)
    EXPECT_NEAR(view_of(optics, {3 * i + color + 0.5f, j + 0.5f}), 1.0 - v, kView) << i << " " << j << " " << color;
}

TEST(SlantedPanel, blue_first_swaps_red_and_blue) {
  const SlantedPanel slanted{.periods = 30.0};
  SlantedPanel swapped = slanted;
  swapped.sub_pixels = striped_sub_pixels(true);
  const Optics a{.panel = {200, 300, 0.3f}, .model = slanted}, b{.panel = {200, 300, 0.3f}, .model = swapped};
  for (int i = 0; i < 200; i += 7)
    for (int color = 0; color < 3; ++color)
      expect_near(ray_of_pixel(a, {3 * i + color + 0.5f, 20.5f}).direction,
                  ray_of_pixel(b, {3 * i + (2 - color) + 0.5f, 20.5f}).direction, kSlope);
}

TEST(SlantedPanel, cells_repeat_by_2_columns_4_rows) {
  // Only blue sub-pixels in odd columns of rows 1, 5 and 9 from the bottom are shifted: half a pixel to the right and a
  // quarter up. Row 4 from the top is row 5 from the bottom of 10 rows. With pixels of 0.3 mm, x = (7.5 + 0.5 - 10) *
  // 0.3 = -0.6 mm and y = (5.5 + 0.25 - 5) * 0.3 = 0.225 mm.
  SlantedPanel slanted{.periods = 8.0};
  slanted.sub_pixels[1][1][2] = {0.5f, 0.25f};
  const Optics optics{.panel = {20, 10, 0.3f}, .model = slanted},
      plain{.panel = {20, 10, 0.3f}, .model = SlantedPanel{.periods = 8.0}};
  expect_near(at_depth(ray_of_pixel(optics, {3 * 7 + 2.5f, 4.5f}), 0.0f), {-0.6f, 0.225f, 0.0f}, kPositionMm);
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 60; ++i) {
      const bool elsewhere = i % 6 == 5 && (j == 4 || j == 8 || j == 0);
      EXPECT_EQ(ray_of_pixel(optics, {i + 0.5f, j + 0.5f}).direction != ray_of_pixel(plain, {i + 0.5f, j + 0.5f}).direction,
                elsewhere)
          << i << " " << j;
    }
}

TEST(SlantedPanel, last_lens_is_as_exact_as_first) {
  // 24576 sub-pixels lie below 2048 lenses, 12 each. The first and the last lens must show the same views.
  const Optics optics{.panel = {8192, 6, 0.06f}, .model = SlantedPanel{.periods = 2048.0, .tilt = 0.0, .center = 0.3}};
  for (int in_lens = 0; in_lens < 12; ++in_lens)
    EXPECT_NEAR(view_of(optics, {in_lens + 0.5f, 2.5f}), view_of(optics, {24564 + in_lens + 0.5f, 2.5f}), 1e-6) << in_lens;
}

TEST(RayGenerator, similarity_gives_the_transformed_ray) {
  OpticsSampler random(21);
  for (int trial = 0; trial < 60; ++trial) {
    const Optics optics = random.every(trial);
    const float scale = std::exp(random.uniform(-4.0f, 4.0f));
    const Vec3f axis = glm::normalize(Vec3f(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1f, 1)));
    const Affine3f world{scale * glm::mat3_cast(glm::angleAxis(random.uniform(-3, 3), axis)),
                         scale * Vec3f(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9))};
    const RayGenerator generator(optics, world);
    const Vec2f pixel(random.uniform(0, film_size(optics).x), random.uniform(0, optics.panel.height));
    const Ray local = ray_of_pixel(optics, pixel), ray = generator.ray(pixel);
    const float size = scale * (glm::length(local.origin) + 10.0f);
    // The tolerances cover several rounding errors of 6e-8.
    expect_near(ray.origin, transform_point(world, local.origin), 1e-6f * size);
    expect_near(ray.direction, glm::normalize(transform_vector(world, local.direction)), 1e-6f);
    EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
    expect_near(generator.forward(), glm::normalize(transform_vector(world, {0, 0, -1})), 1e-6f);
  }
}

TEST(RayGenerator, depth_is_the_distance_between_end_planes) {
  Optics optics{.panel = {}, .model = LenticularSheet{}, .z_front_mm = 30.0f, .z_back_mm = 20.0f};
  EXPECT_NEAR(RayGenerator(optics, {Mat3f(3.0f), {1, 2, 3}}).depth(), 150.0f, 1e-3f);
  optics.z_back_mm = kInfinity;
  EXPECT_EQ(RayGenerator(optics).depth(), kInfinity);
}

TEST(RayGenerator, any_count_writes_exactly_its_rays) {
  const Optics optics{.panel = {}, .model = MicrolensArray{}};
  const RayGenerator generator(optics);
  for (int count : {0, 1, 15, 16, 17, 33}) {
    std::vector<float> px(40), py(40), out(6 * 40, -7.0f);
    for (int i = 0; i < 40; ++i) px[i] = 11.3f * i, py[i] = 5.7f * i;
    generator.rays(px.data(), py.data(), count, {&out[0], &out[40], &out[80], &out[120], &out[160], &out[200]});
    for (int c = 0; c < 6; ++c)
      for (int i = 0; i < 40; ++i) {
        const Ray ray = generator.ray({px[i], py[i]});
        const float wanted = c < 3 ? ray.origin[c] : ray.direction[c - 3];
        EXPECT_EQ(out[40 * c + i], i < count ? wanted : -7.0f) << "component " << c << " ray " << i << " of " << count;
      }
  }
}

}  // namespace
}  // namespace lippmann

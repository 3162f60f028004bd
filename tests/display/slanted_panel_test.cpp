#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/display/load_display.hpp"

namespace lippmann {
namespace {

/// Returns where a sub-pixel's ray meets the plane of the eyes, from 0 to 1 across the view cone.
double view_of(const Optics& optics, int i, int j, int color) {
  const auto& slanted = std::get<SlantedPanel>(optics.model);
  const Ray ray = ray_of_pixel(optics, {3 * i + color + 0.5f, j + 0.5f});
  const double to_eye = (slanted.distance_mm - ray.origin.z) / ray.direction.z;
  return 0.5 + std::atan((ray.origin.x + to_eye * ray.direction.x) / slanted.distance_mm) / slanted.view_cone;
}

/// Single-precision rays meet the plane of the eyes with an error of 3e-5 mm, and the cone is about 800 mm wide there.
constexpr double kView = 1e-6;

TEST(SlantedDisplay, portrait_has_the_published_periods_and_tilt) {
  // Lens periods: pitch * width / dpi * cos(atan(1 / slope)) = 52 * 1536 / 324 * cos(atan(-1 / 7)) = 244.0409. Tilt:
  // height / (width * slope) = 2048 / (1536 * -7) = -0.1904762.
  const Display portrait = load_display("looking-glass-portrait");
  EXPECT_NEAR(periods_of(portrait), 244.041, 5e-4);
  EXPECT_NEAR(tilt_of(portrait), -0.190476, 5e-7);
}

TEST(SlantedDisplay, portrait_sub_pixel_table_by_hand) {
  // Views v of sub-pixels c (0 red, 1 green, 2 blue) of the pixels (i, j), with the position x = (i + 1/2) / 1536, y = 1 - (j +
  // 1/2) / 2048, the phase z = (x + c / 4608 - 0.19047619 y) 244.0408826 - 0.5 and v = 1 - fract(z):
  //   i     j     c   x           y           z           v
  //   0     0     0   0.00032552  0.99975586  -46.893189  0.893189
  //   0     0     1                           -46.840228  0.840228
  //   0     0     2                           -46.787268  0.787268
  //   1535  0     2   0.99967448  0.99975586  197.094734  0.905266
  //   767   1023  1   0.49967448  0.50024414   98.240624  0.759376
  //   100   2047  0   0.06542969  0.00024414   15.456170  0.543830
  //   1535  2047  2   0.99967448  0.00024414  243.556014  0.443986
  const Optics optics = native_optics(load_display("portrait"));
  EXPECT_EQ(film_size(optics), Vec2i(4608, 2048));
  EXPECT_NEAR(optics.panel.pixel_pitch_mm, 25.4 / 324, 1e-8);
  const struct {
    int i, j, color;
    double v;
  } table[] = {{0, 0, 0, 0.893189},      {0, 0, 1, 0.840228},      {0, 0, 2, 0.787268},      {1535, 0, 2, 0.905266},
               {767, 1023, 1, 0.759376}, {100, 2047, 0, 0.543830}, {1535, 2047, 2, 0.443986}};
  for (const auto& [i, j, color, v] : table)
    EXPECT_NEAR(view_of(optics, i, j, color), v, kView) << i << " " << j << " " << color;
}

TEST(SlantedDisplay, third_generation_sub_pixel_table_by_hand) {
  // The panel has 3840 x 2160 pixels, P = 600.5274503 lens periods and the tilt T = -0.08152174.
  // Offsets (ox, oy) of the sub-pixels in even columns: red (-0.31, 0.25), green (0.28, 0.25), blue (0, -0.25). In odd columns,
  // oy has the opposite sign.
  // Position: x = (i + 1/2) / 3840, y = 1 - (j + 1/2) / 2160. Phase: z = (x + ox / 3840 + (y + oy / 2160) T) P - 0.5.
  // View: v = 1 - fract(z). Columns of the table: pixel i, j, colour, z and v.
  //   0    0    r  -49.420662  v 0.420662     2000 1000 b  286.078698  v 0.921302
  //   1    0    r  -49.252943  v 0.252943     2001 1000 b  286.223753  v 0.776247
  //   0    0    g  -49.328394  v 0.328394     3839 2159 g  599.987379  v 0.012621
  //   1    0    b  -49.215795  v 0.215795
  const Optics optics = native_optics(load_display("looking-glass-16-landscape"));
  const struct {
    int i, j, color;
    double v;
  } table[] = {{0, 0, 0, 0.420662},       {1, 0, 0, 0.252943},       {0, 0, 1, 0.328394},      {1, 0, 2, 0.215795},
               {2000, 1000, 2, 0.921302}, {2001, 1000, 2, 0.776247}, {3839, 2159, 1, 0.012621}};
  for (const auto& [i, j, color, v] : table)
    EXPECT_NEAR(view_of(optics, i, j, color), v, kView) << i << " " << j << " " << color;
}

TEST(SlantedDisplay, flipped_portrait_sub_pixel_table_by_hand) {
  // Lens periods: P = 52.594 * 1536 / 324 cos(atan(1 / -7.2115)) = 246.97136. Tilt: T = -2048 / (1536 * -7.2115) = 0.18488987.
  // Position: x = (i + 1/2) / 1536, y = 1 - (j + 1/2) / 2048. Phase of sub-pixel c (0 red, 1 green, 2 blue) of pixel (i, j):
  // z = (x - c / 4608 + T y) P - 0.40277. View: v = 1 - fract(z).
  //   i     j     c   x           y           z           v
  //   0     0     0   0.00032552  0.99975586  45.328980   0.671020
  //   0     0     1                           45.275384   0.724616
  //   0     0     2                           45.221788   0.778212
  //   1535  2047  2   0.99967448  0.00024414  246.392153  0.607847
  // flipImageY changes no value.
  Display d;
  d.calibration = {.pitch = 52.594, .slope = -7.2115, .center = 0.40277, .flip_image_x = true};
  const struct {
    int i, j, color;
    double v;
  } table[] = {{0, 0, 0, 0.671020}, {0, 0, 1, 0.724616}, {0, 0, 2, 0.778212}, {1535, 2047, 2, 0.607847}};
  for (const bool flip_y : {false, true}) {
    d.calibration.flip_image_y = flip_y;
    const Optics optics = native_optics(d);
    for (const auto& [i, j, color, v] : table)
      EXPECT_NEAR(view_of(optics, i, j, color), v, kView) << i << " " << j << " " << color;
  }
}

TEST(SlantedDisplay, flipping_only_the_slope_keeps_steps) {
  // View: v = 1 - fract(z). Red (c = 0) at pixel (0, 0) has z = 45.328980, as in the test above. A sub-pixel changes z by P /
  // 4608 = 0.053597. With kSlope, sub-pixels are not mirrored, so green (c = 1) has z = 45.382577 and v = 0.617423.
  // kSlopeStepAndCenter mirrors them and adds 1/2 to the centre, so green has z = 45.328980 - 0.053597 - 0.5 = 44.775384.
  Display d;
  d.calibration = {.pitch = 52.594, .slope = -7.2115, .center = 0.40277, .flip_image_x = true};
  d.calibration.flip = Calibration::Flip::kSlope;
  EXPECT_NEAR(view_of(native_optics(d), 0, 0, 0), 0.671020, kView);
  EXPECT_NEAR(view_of(native_optics(d), 0, 0, 1), 0.617423, kView);
  d.calibration.flip = Calibration::Flip::kSlopeStepAndCenter;
  EXPECT_NEAR(view_of(native_optics(d), 0, 0, 1), 0.224616, kView);
}

double formula(const Display& d, int i, int j, int color, int cell) {
  const Calibration& c = d.calibration;
  const double w = d.pixels.x, h = d.pixels.y;
  const double p = c.pitch * w / d.dpi * std::cos(std::atan(1.0 / c.slope));
  const double t = h / (w * c.slope) * (c.flip_image_x ? -1 : 1);
  const double s = (c.flip_image_x && c.flip != Calibration::Flip::kSlope ? -1 : 1) / (3 * w);
  const double center = c.center + (c.flip_image_x && c.flip == Calibration::Flip::kSlopeStepAndCenter ? 0.5 : 0.0);
  double x = (i + 0.5) / w, y = 1 - (j + 0.5) / h;
  const int k = c.flip_sub_pixels ? 2 - color : color;
  if (c.cells.empty())
    x += k * s;
  else
    x += c.cells[cell][k].x / w, y += c.cells[cell][k].y / h;
  const double z = (x + y * t) * p - center;
  const bool inverted = c.inversion == Calibration::Inversion::kAlways || c.invert;
  return inverted ? 1 - (z - std::floor(z)) : z - std::floor(z);
}

Display small_display() {
  Display d;
  d.pixels = {60, 41};
  d.dpi = 100.0;
  d.calibration.pitch = 16.3, d.calibration.slope = -5.3, d.calibration.center = 0.37;
  return d;
}

void expect_formula(const Display& d, int (*cell)(int column, int row_from_bottom)) {
  const Optics optics = native_optics(d);
  for (int j = 0; j < d.pixels.y; ++j)
    for (int i = 0; i < d.pixels.x; ++i)
      for (int color = 0; color < 3; ++color) {
        const double v = formula(d, i, j, color, cell(i, d.pixels.y - 1 - j));
        if (std::min(v, 1 - v) < 1e-5) continue;
        EXPECT_NEAR(view_of(optics, i, j, color), v, 2 * kView) << i << " " << j << " " << color;
      }
}

int first_cell(int, int) { return 0; }

TEST(SlantedDisplay, every_flip_matches_the_formula) {
  for (int flags = 0; flags < 48; ++flags) {
    Display d = small_display();
    d.calibration.flip = static_cast<Calibration::Flip>(flags / 16);
    d.calibration.flip_image_x = flags & 1, d.calibration.flip_image_y = flags & 2, d.calibration.flip_sub_pixels = flags & 4;
    if (flags & 8) d.calibration.invert = false, d.calibration.inversion = Calibration::Inversion::kIfFlagged;
    SCOPED_TRACE(flags);
    expect_formula(d, first_cell);
  }
}

TEST(SlantedDisplay, views_are_inverted_by_default) {
  Display d = small_display();
  d.calibration.invert = false;
  expect_formula(d, first_cell);
  EXPECT_TRUE(slanted_panel(d, 500.0).inverted);
}

TEST(SlantedDisplay, every_cell_pattern_matches_the_formula) {
  Display d = small_display();
  for (int cell = 0; cell < 4; ++cell)
    d.calibration.cells.push_back({Vec2f(-0.3f, 0.01f * cell), Vec2f(0.02f * cell, 0.2f), Vec2f(0.3f, -0.1f * cell)});
  int (*by_columns[])(int, int) = {first_cell, [](int i, int j) { return (i + j) % 2; }, [](int i, int) { return i % 2; },
                                   [](int i, int j) { return (j + 2 * (i % 2)) % 4; }, [](int, int j) { return j % 2; }};
  for (int pattern = 0; pattern <= 4; ++pattern) {
    SCOPED_TRACE(pattern);
    d.calibration.cell_pattern = pattern;
    expect_formula(d, by_columns[pattern]);
  }
  d.calibration.patterns = Calibration::Patterns::kRows;
  d.calibration.cell_pattern = 2;
  expect_formula(d, [](int, int j) { return j % 4; });
  d.calibration.cell_pattern = 4;
  expect_formula(d, [](int i, int) { return i % 2; });
  d.calibration.flip_sub_pixels = true;
  expect_formula(d, [](int i, int) { return i % 2; });
}

TEST(SlantedDisplay, missing_cells_are_repeated) {
  Display d = small_display();
  d.calibration.cells = {{Vec2f(-0.3f, 0.1f), Vec2f(0.0f), Vec2f(0.3f, 0.0f)},
                         {Vec2f(-0.2f, 0.0f), Vec2f(0.1f), Vec2f(0.3f, 0.2f)}};
  d.calibration.cell_pattern = 3;
  expect_formula(d, [](int i, int j) { return (j + 2 * (i % 2)) % 4 % 2; });
}

}  // namespace
}  // namespace lippmann

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "formats/estimate_lens_grid.hpp"
#include "formats/lens_grid_file.hpp"
#include "formats/plenoptic_views.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

/// Returns the light through a lens at the centre `lens`, in the direction of the pixel at `offset` from this centre,
/// in pixels.
using RawLight = std::function<double(Vec2d lens, Vec2d offset)>;

/// Returns the centre of the lens below which a pixel lies. Does not support kHexagonalColumns.
Vec2d nearest_lens(const LensGrid& grid, Vec2d place) {
  const double c = std::cos(grid.rotation), s = std::sin(grid.rotation);
  const Vec2d from = place - grid.offset_px;
  const Vec2d lenses((c * from.x + s * from.y) / grid.pitch_px, (c * from.y - s * from.x) / grid.row_pitch_px);
  Vec2d nearest(1e9);
  // The lens is in the row above or below the pixel, also if every second row is shifted.
  for (int row = static_cast<int>(std::floor(lenses.y)), last = row + 1; row <= last; ++row) {
    const double shift = grid.arrangement == LensArrangement::kHexagonal && row % 2 != 0 ? 0.5 : 0.0;
    const Vec2d centre = lens_centre(grid, static_cast<int>(std::lround(lenses.x - shift)), row);
    if (glm::distance(centre, place) < glm::distance(nearest, place)) nearest = centre;
  }
  return nearest;
}

/// Each pixel is the mean of 3 x 3 points in it.
Image raw_picture(const LensGrid& grid, Vec2i size, const RawLight& light, int channels = 3) {
  Image raw(size.x, size.y, channels);
  constexpr int kParts = 3;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      double sum = 0.0;
      for (int part = 0; part < kParts * kParts; ++part) {
        const Vec2d place(x + (part % kParts + 0.5) / kParts, y + (part / kParts + 0.5) / kParts);
        const Vec2d centre = nearest_lens(grid, place);
        sum += light(centre, place - centre);
      }
      for (int c = 0; c < channels; ++c) raw.pixel(x, y)[c] = static_cast<float>(sum / (kParts * kParts));
    }
  return raw;
}

/// White picture: below each lens, a round image of the main lens's aperture with a dark rim and a soft edge.
RawLight white_light(double pitch) {
  return [pitch](Vec2d, Vec2d offset) {
    const double share = glm::length(offset) / (0.48 * pitch);
    return share < 1.0 ? std::pow(1.0 - 0.9 * share * share, 2) : 0.01;
  };
}

/// Returns the largest distance in pixels from a lens of `estimate` to the nearest lens of `truth`. Equal grids may have
/// offsets that differ by whole lenses.
double grid_distance(const LensGrid& estimate, const LensGrid& truth, Vec2i size) {
  double most = 0.0;
  for (int j = -100; j <= 100; ++j)
    for (int i = -100; i <= 100; ++i) {
      const Vec2d centre = lens_centre(estimate, i, j);
      if (centre.x < 0.0 || centre.y < 0.0 || centre.x > size.x || centre.y > size.y) continue;
      most = std::max(most, glm::distance(centre, nearest_lens(truth, centre)));
    }
  return most;
}

/// Expects that the grid is found to a twentieth of a pixel. The residuals of single lens centres may be a tenth of a
/// pixel.
void expect_grid_found(const LensGrid& truth, Vec2i size) {
  const LensGridFit fit = estimate_lens_grid(raw_picture(truth, size, white_light(truth.pitch_px), 1), "white");
  EXPECT_EQ(fit.grid.arrangement, truth.arrangement);
  EXPECT_NEAR(fit.grid.pitch_px, truth.pitch_px, 2e-3);
  EXPECT_NEAR(fit.grid.row_pitch_px, truth.row_pitch_px, 2e-3);
  EXPECT_NEAR(fit.grid.rotation, truth.rotation, 2e-4);
  EXPECT_LT(grid_distance(fit.grid, truth, size), 0.05);
  EXPECT_LT(fit.residual_px, 0.1);
  EXPECT_GT(fit.lenses, 0.8 * size.x * size.y / (truth.pitch_px * truth.row_pitch_px));
}

TEST(LensGridEstimate, finds_square_lenses_of_fractional_pitch) {
  expect_grid_found(lens_grid(10.135, radians(0.7f), {7.3, 4.1}, LensArrangement::kSquare), {520, 430});
}

TEST(LensGridEstimate, finds_hexagonal_lenses) {
  expect_grid_found(lens_grid(14.29, radians(-2.3f), {3.0, 8.6}, LensArrangement::kHexagonal), {610, 500});
}

TEST(LensGridEstimate, finds_rows_that_are_scaled) {
  LensGrid grid = lens_grid(9.94, 0.003, {6.0, 6.0}, LensArrangement::kHexagonal);
  grid.row_pitch_px *= 1.004;
  expect_grid_found(grid, {420, 420});
}

LensGridFit fit_of_lenses(const LensGrid& grid, double across) {
  const int side = static_cast<int>(std::lround(across * grid.pitch_px));
  const Image white = raw_picture(grid, {side, side}, white_light(grid.pitch_px), 1);
  const LensGridFit fit = estimate_lens_grid(white, "white");
  EXPECT_LT(grid_distance(fit.grid, grid, {side, side}), 0.1);
  return fit;
}

/// Ten lenses with a pitch of 10.4 pixels also repeat every 10.4 / sqrt(2) = 7.35 pixels along the diagonals. This
/// period must not be taken for the pitch.
TEST(LensGridEstimate, six_to_forty_lenses_are_enough) {
  struct Case {
    double across, pitch, rotation_deg;
  };
  for (const Case& c : {Case{6, 17.0, 0.0}, Case{6, 10.7, 13.0}, Case{6.5, 10.4, -2.3}, Case{7, 14.29, 14.0}, Case{8, 8.3, 0.7},
                        Case{10, 10.4, 0.0}, Case{12, 10.4, -9.0}, Case{15, 9.94, 0.2}, Case{20, 7.3, -14.0},
                        Case{30, 5.3, 5.0}, Case{40, 5.3, 0.0}}) {
    const double rotation = c.rotation_deg * std::numbers::pi / 180.0;
    for (const LensArrangement arrangement : {LensArrangement::kSquare, LensArrangement::kHexagonal}) {
      const LensGridFit fit = fit_of_lenses(lens_grid(c.pitch, rotation, {3.3, 0.6 * c.pitch}, arrangement), c.across);
      EXPECT_EQ(fit.grid.arrangement, arrangement) << c.across << " lenses of " << c.pitch;
      EXPECT_NEAR(fit.grid.pitch_px, c.pitch, 5e-3 * c.pitch) << c.across;
      EXPECT_NEAR(fit.grid.rotation, rotation, 5e-3) << c.across;
    }
  }
  for (const double turn_deg : {30.0, 44.0})
    EXPECT_NEAR(fit_of_lenses(lens_grid(10.4, turn_deg * std::numbers::pi / 180.0, {1.0, 2.0}, LensArrangement::kSquare), 9.0)
                    .grid.rotation,
                turn_deg * std::numbers::pi / 180.0, 5e-3);
}

/// With two or three lenses across, the lowest frequency of the grid looks like vignetting. The estimate would find
/// only its harmonics, which are those of a finer grid.
TEST(LensGridEstimate, too_few_lenses_are_refused) {
  const LensGrid grid = lens_grid(40.0, 0.03, {7.0, 11.0}, LensArrangement::kSquare);
  for (const double across : {2.0, 3.0})
    EXPECT_THAT(error_message([&] { fit_of_lenses(grid, across); }), HasSubstr("fewer than six lenses")) << across;
}

TEST(LensGridEstimate, finds_columns_by_swapped_axes) {
  const LensGrid rows = lens_grid(11.2, 0.02, {5.5, 7.0}, LensArrangement::kHexagonal);
  const Image white = raw_picture(rows, {400, 320}, white_light(11.2), 1);
  Image swapped(320, 400, 1);
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 400; ++x) *swapped.pixel(y, x) = *white.pixel(x, y);
  const LensGridFit fit = estimate_lens_grid(swapped, "white");
  EXPECT_EQ(fit.grid.arrangement, LensArrangement::kHexagonalColumns);
  EXPECT_LT(grid_distance(transposed(fit.grid), rows, {400, 320}), 0.05);
}

TEST(LensGridEstimate, survives_dust_and_falling_light) {
  const LensGrid truth = lens_grid(12.4, 0.01, {2.0, 9.0}, LensArrangement::kHexagonal);
  const Vec2i size(500, 500);
  Image white = raw_picture(truth, size, white_light(12.4), 1);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const Vec2d from = Vec2d(x, y) - 250.0;
      *white.pixel(x, y) *= static_cast<float>(1.0 / (1.0 + glm::dot(from, from) / (300.0 * 300.0)));
      if (glm::length(from - Vec2d(60.0, -90.0)) < 15.0) *white.pixel(x, y) *= 0.05f;
    }
  EXPECT_LT(grid_distance(estimate_lens_grid(white, "white").grid, truth, size), 0.1);
}

TEST(LensGridEstimate, refuses_pictures_without_lenses) {
  Image noise(300, 300, 1);
  std::uint32_t state = 1;
  for (float& value : noise.data) value = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / (1 << 24);
  EXPECT_THAT(error_message([&] { estimate_lens_grid(noise, "w.png"); }), HasSubstr("w.png: cannot find a lens grid"));
  EXPECT_THAT(error_message([&] { estimate_lens_grid(Image(300, 300, 1), "w.png"); }), HasSubstr("is not periodic"));
  EXPECT_THAT(error_message([&] { estimate_lens_grid(Image(40, 300, 1), "w.png"); }), HasSubstr("40x300 pixels"));
  Image stripes(300, 300, 1);
  for (int i = 0; i < 300 * 300; ++i) stripes.data[static_cast<std::size_t>(i)] = i % 300 % 10 < 5 ? 1.0f : 0.0f;
  EXPECT_THROW(estimate_lens_grid(stripes, "w.png"), Error);
}

/// Light that varies slowly over the picture and is linear in the direction.
double known_light(Vec2d lens, Vec2d offset) {
  return 0.5 + 0.2 * std::sin(0.021 * lens.x) * std::cos(0.017 * lens.y) + 0.02 * offset.x - 0.013 * offset.y;
}

LightField views_of(const Image& raw, const PlenopticCalibration& calibration, ViewGrid views) {
  return plenoptic_views(raw, calibration, views, Image(), "raw");
}

float view_sample(const LightField& field, int view, int x, int y) {
  return std::get<Image>(field.stack).pixel(x, view * field.view_size.y + y)[0];
}

TEST(PlenopticViews, turned_square_lenses_give_known_views) {
  const LensGrid grid = lens_grid(10.135, 0.012, {6.7, 5.9}, LensArrangement::kSquare);
  for (const bool lanczos : {false, true}) {
    const LightField field = views_of(raw_picture(grid, {420, 330}, known_light), {.grid = grid, .lanczos = lanczos}, {7, 5});
    ASSERT_EQ(field.grid, (ViewGrid{7, 5}));
    // The views cover the largest rectangle of lenses in the picture. Its top left lens is (first_column, first_row).
    int first_column = 0, first_row = 0;
    for (; lens_centre(grid, first_column, field.view_size.y - 1).x < 3.25; ++first_column) {
    }
    for (; lens_centre(grid, 0, first_row).y < 2.25; ++first_row) {
    }
    const double c = std::cos(grid.rotation), s = std::sin(grid.rotation);
    for (const int view : {0, 17, 34})
      for (const Vec2i at : {Vec2i(0, 0), Vec2i(20, 9), field.view_size - 1}) {
        const Vec2d along(view % 7 - 3, 2 - view / 7);
        const Vec2d offset(c * along.x - s * along.y, s * along.x + c * along.y);
        const Vec2d lens = lens_centre(grid, first_column + at.x, first_row + at.y);
        // Linear sampling of linear light is exact. Lanczos sampling also reads pixels of the neighbouring lens. Near
        // the picture's edge, samples may lie a quarter of a pixel beyond the last pixel's centre.
        const double tolerance = at.x != 20 ? 0.25 * 0.024 : lanczos ? 2e-3 : 1e-5;
        EXPECT_NEAR(view_sample(field, view, at.x, at.y), known_light(lens, offset), tolerance) << view << " " << at.x;
      }
  }
}

TEST(PlenopticViews, hexagonal_rows_become_square_pixels) {
  const LensGrid grid = lens_grid(12.0, 0.0, {6.0, 6.0}, LensArrangement::kHexagonal);
  const RawLight ramp = [](Vec2d lens, Vec2d) { return 0.001 * lens.x + 0.0005 * lens.y; };
  for (const bool lanczos : {false, true}) {
    const LightField field = views_of(raw_picture(grid, {360, 300}, ramp), {.grid = grid, .lanczos = lanczos}, {3, 3});
    const double rows = grid.row_pitch_px;
    // Lens centres are at 12 to 348 pixels in shifted rows, and at 6 to 342 pixels in other rows. The views cover the common
    // range, 12 to 342.
    ASSERT_EQ(field.view_size, Vec2i(static_cast<int>(330.0 / rows) + 1, 29));
    for (const Vec2i at : {Vec2i(4, 4), Vec2i(15, 11), Vec2i(27, 20)})
      EXPECT_NEAR(view_sample(field, 4, at.x, at.y), 0.001 * (12.0 + at.x * rows) + 0.0005 * (6.0 + at.y * rows), 1e-3);
  }
}

TEST(PlenopticViews, vignetting_is_divided_out) {
  const LensGrid grid = lens_grid(11.3, -0.02, {5.0, 8.0}, LensArrangement::kHexagonal);
  const RawLight white = white_light(11.3);
  const auto darker = [&](Vec2d lens, Vec2d offset) { return known_light(lens, {}) * white(lens, offset); };
  Image light = raw_picture(grid, {300, 260}, darker);
  divide_by_white(light, white_shares(raw_picture(grid, {300, 260}, white)), "raw");
  const LightField field = views_of(light, {.grid = grid}, {5, 5});
  for (const Vec2i at : {Vec2i(3, 3), Vec2i(14, 12)})
    // These views are at the corners of the aperture, where the raw picture has half of the light.
    for (const int view : {0, 4, 20, 24})
      EXPECT_NEAR(view_sample(field, view, at.x, at.y) / view_sample(field, 12, at.x, at.y), 1.0, 0.01);
}

TEST(PlenopticViews, inverted_lenses_turn_views_round) {
  const LensGrid grid = lens_grid(10.0, 0.0, {5.0, 5.0}, LensArrangement::kSquare);
  const Image raw = raw_picture(grid, {60, 60}, [](Vec2d, Vec2d offset) { return 0.5 + 0.01 * offset.x - 0.03 * offset.y; });
  const LightField upright = views_of(raw, {.grid = grid}, {10, 10});
  // the lower right eye, 4.5 pixels from the middle in x and y
  EXPECT_NEAR(view_sample(upright, 9, 2, 2), 0.5 + 0.045 - 0.135, 1e-5);
  const LightField turned = views_of(raw, {.grid = grid, .inverted = true}, {10, 10});
  for (int view = 0; view < 100; ++view)
    EXPECT_EQ(view_sample(turned, view, 2, 2), view_sample(upright, 99 - view, 2, 2)) << view;
}

TEST(PlenopticViews, lenses_of_whole_pixels_are_eslf) {
  const test::TempDir dir;
  Image8 codes{40, 30, {}};
  for (int i = 0; i < 3600; ++i) codes.rgb.push_back(static_cast<unsigned char>(i * 37 + i / 256));
  write_picture(dir / "raw.png", codes);
  FormatOptions options;
  options.views = ViewGrid{5, 5};
  options.plenoptic = PlenopticCalibration{.grid = lens_grid(5.0, 0.0, {2.5, 2.5}, LensArrangement::kSquare)};
  const LightField plenoptic = find_format("plenoptic", "from").read(dir / "raw.png", options);
  const LightField eslf = find_format("eslf", "from").read(dir / "raw.png", options);
  EXPECT_EQ(plenoptic.view_size, eslf.view_size);
  EXPECT_DOUBLE_EQ(plenoptic.aspect, eslf.aspect);
  EXPECT_EQ(std::get<Image8>(plenoptic.stack).rgb, std::get<Image8>(eslf.stack).rgb);
}

TEST(PlenopticViews, impossible_grids_are_refused) {
  const Image raw(50, 50, 3);
  PlenopticCalibration calibration{.grid = lens_grid(10.0, 0.0, {5.0, 5.0}, LensArrangement::kSquare)};
  EXPECT_THAT(error_message([&] { views_of(raw, calibration, {11, 3}); }), HasSubstr("up to 10x10"));
  calibration.grid = lens_grid(40.0, 0.0, {20.0, 20.0}, LensArrangement::kSquare);
  EXPECT_THAT(error_message([&] { views_of(raw, calibration, {30, 30}); }), HasSubstr("fewer than 2x2 lenses"));
  Image other(40, 50, 3);
  EXPECT_THAT(error_message([&] { divide_by_white(other, white_shares(raw), "raw"); }), HasSubstr("40x50 pixels"));
}

/// Raw picture of a blurred spot on a wall at the distance `z` in front of the main lens.
Image picture_of_wall(const Optics& optics, double distance, double z, Vec2d spot, double sigma) {
  Image raw(optics.panel.width, optics.panel.height, 3);
  for (int y = 0; y < raw.height; ++y)
    for (int x = 0; x < raw.width; ++x) {
      const Vec2f pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      if (is_blocked(optics, pixel)) continue;
      const Ray ray = ray_of_pixel(optics, pixel);
      const Vec3d from(ray.origin), to(ray.direction);
      const Vec2d off = Vec2d(from) + Vec2d(to) * ((distance - z - from.z) / to.z) - spot;
      const auto light = static_cast<float>(std::exp(-0.5 * glm::dot(off, off) / (sigma * sigma)));
      for (const int c : {0, 1, 2}) raw.pixel(x, y)[c] = light;
    }
  return raw;
}

Vec2d centroid_of_view(const LightField& field, int view) {
  double sum = 0.0;
  Vec2d mean(0.0);
  for (int y = 0; y < field.view_size.y; ++y)
    for (int x = 0; x < field.view_size.x; ++x) {
      const auto light = static_cast<double>(view_sample(field, view, x, y));
      sum += light, mean += light * Vec2d(x, y);
    }
  return mean / sum;
}

/// The main lens has f = 100 mm and is focused at Zf = 2 m, so the lens array is s = 105.263 mm behind it. For the pixel width
/// m and the gap b, neighbouring views are m s / b apart on the main lens. For the lens pitch p, a spot at the distance Z moves
/// from view to view by (m s / b) s (1/Zf - 1/Z) / p lenses.
TEST(PlenopticViews, simulated_camera_has_parallax_of_the_thin_lens) {
  constexpr double kFocal = 100.0, kFocus = 2000.0, kGap = 0.5, kPixel = 0.01;
  const double s = kFocal * kFocus / (kFocus - kFocal), eye_step = kPixel * s / kGap;
  for (const double pixels : {9.0, 9.37}) {
    const double pitch = pixels * kPixel / (1.0 + kGap / s);
    const Optics optics{.panel = {240, 240, static_cast<float>(kPixel)},
                        .model = PlenopticCamera{.lens_pitch_mm = static_cast<float>(pitch),
                                                 .gap_mm = static_cast<float>(kGap),
                                                 .offset_mm = Vec2f(static_cast<float>(0.5 * pitch)),
                                                 .focal_length_mm = static_cast<float>(kFocal),
                                                 .f_number = 4.0f,
                                                 .distance_mm = static_cast<float>(kFocus)}};
    const LensGrid grid = *lens_grid_of(optics);
    EXPECT_NEAR(grid.pitch_px, pixels, 1e-4);
    for (const double z : {1000.0, 1600.0, 2000.0, 4000.0}) {
      const Image raw = picture_of_wall(optics, kFocus, z, Vec2d(1.3, -0.8), 1.5 * pitch * z / s);
      const LightField views = views_of(raw, {.grid = grid}, {9, 9});
      const double disparity = s * (1.0 / kFocus - 1.0 / z) * eye_step / pitch;
      for (const int steps : {-2, 1, 3}) {
        const Vec2d across = centroid_of_view(views, 40 + steps) - centroid_of_view(views, 40),
                    up = centroid_of_view(views, 40 + 9 * steps) - centroid_of_view(views, 40);
        // For pitches other than 9 pixels, light is interpolated between pixels.
        const double tolerance = pixels == 9.0 ? 1e-3 : 2e-2;
        EXPECT_NEAR(across.x, steps * disparity, tolerance) << z;
        EXPECT_NEAR(across.y, 0.0, tolerance) << z;
        EXPECT_NEAR(up.y, -steps * disparity, tolerance) << z;
      }
    }
  }
}

TEST(PlenopticFormat, side_file_names_the_grid) {
  const test::TempDir dir;
  write_picture(dir / "raw.png", Image8{60, 60, std::vector<unsigned char>(10800, 90)});
  std::ofstream(dir / "raw.png.json") << R"({"plenoptic": {"arrangement": "square", "pitch_px": 10.1, "offset_px": [5, 5]}})";
  const OpenedLightField opened = open_light_field(dir / "raw.png", "", {});
  EXPECT_EQ(opened.format, "plenoptic");
  EXPECT_EQ(opened.field.grid, (ViewGrid{10, 10}));
  const LensGrid grid = *read_lens_grid(dir / "raw.png");
  EXPECT_EQ(grid, lens_grid(10.1, 0.0, {5.0, 5.0}, LensArrangement::kSquare));
  const LensGrid other = lens_grid(9.3, 0.0, {4.5, 6.25}, LensArrangement::kHexagonal);
  EXPECT_EQ(write_lens_grid(dir / "raw.png", other), dir / "raw.png.json");
  EXPECT_EQ(read_lens_grid(dir / "raw.png"), other);
}

TEST(PlenopticFormat, problems_name_the_key) {
  const auto complaint = [](const char* text) { return error_message([&] { parse_lens_grid(text, "a.json"); }); };
  EXPECT_THAT(complaint(R"({"plenoptic": {"arrangement": "round", "pitch_px": 9, "offset_px": [1, 1]}})"),
              HasSubstr("plenoptic.arrangement"));
  EXPECT_THAT(complaint(R"({"plenoptic": {"arrangement": "square", "pitch_px": 1, "offset_px": [1, 1]}})"),
              HasSubstr("a number from 2 to 4096"));
  EXPECT_THAT(complaint(R"({"plenoptic": {"arrangement": "square", "pitch_px": 9}})"), HasSubstr("offset_px"));
  EXPECT_THAT(complaint(R"({"plenoptic": {"arrangement": "square", "pitch_px": 9, "offset_px": [1, 1], "pich": 1}})"),
              HasSubstr("there is no such key"));
}

TEST(PlenopticFormat, unknown_grid_and_writing_are_refused) {
  const test::TempDir dir;
  write_picture(dir / "raw.png", Image8{60, 60, std::vector<unsigned char>(10800, 90)});
  const LightFieldFormat& format = find_format("plenoptic", "from");
  EXPECT_THAT(error_message([&] { format.read(dir / "raw.png", {}); }), HasSubstr("lens-pitch-px"));
  EXPECT_THAT(error_message([] { find_output_format("plenoptic", "to"); }), HasSubstr("eslf or integral"));
}

/// Returns a camera with the focal length 50 mm, focused at 800 mm. Below its lenses are images of 9 x 9 pixels. The array is
/// array_shift_mm behind the image of the plane in focus.
Optics plenoptic_optics(float array_shift_mm, LensPacking packing = LensPacking::kSquare) {
  const double t = 1.0 / (1.0 / 50.0 - 1.0 / 800.0) + static_cast<double>(array_shift_mm), b = 2.0, cell_mm = 9.0 * 0.01;
  const auto pitch = static_cast<float>(cell_mm / (1.0 + b / t));
  return {.panel = {180, 135, 0.01f},
          .model = PlenopticCamera{.packing = packing,
                                   .lens_pitch_mm = pitch,
                                   .gap_mm = static_cast<float>(b),
                                   .offset_mm = {0.5f * pitch, 0.0f},
                                   .focal_length_mm = 50.0f,
                                   .f_number = 1.0f,
                                   .distance_mm = 800.0f,
                                   .array_shift_mm = array_shift_mm}};
}

LightField views_of(const Optics& optics, ViewGrid views) {
  const Image raw(optics.panel.width, optics.panel.height, 3), z(optics.panel.width, optics.panel.height, 1);
  return plenoptic_views(raw, {.grid = lens_grid_of(optics), .optics = optics}, views, raw, "a", &z);
}

/// Compares the cameras of views with rays: a pixel below a lens and the pixel of the view must have the same ray. With a shift
/// of -4 mm, the lens array is so near to the main lens that no plane has zero disparity.
TEST(PlenopticViews, cameras_see_along_the_rays_of_the_sensor) {
  for (const float shift_mm : {0.0f, 1.5f, -4.0f})
    for (const LensPacking packing : {LensPacking::kSquare, LensPacking::kHexagonal}) {
      const Optics optics = plenoptic_optics(shift_mm, packing);
      const LensGrid grid = lens_grid_of(optics).value();
      const LightField field = views_of(optics, {5, 3});
      EXPECT_EQ(field.cameras.has_value(), shift_mm > -3.0f);
      const std::vector<PosedCamera> cameras = posed_cameras(field, "a");
      // If all cameras lie in one plane, the origin of their coordinates differs from that of the display frame.
      const Vec3d moved = Vec3d(0.0, 0.0, 800.0) - cameras[7].position_mm;
      for (const int view : {0, 4, 7, 10}) {
        const PosedCamera& camera = cameras[static_cast<std::size_t>(view)];
        const Vec2d offset_px(view % 5 - 2, 1 - view / 5);
        for (const Vec2i lens : {Vec2i(2, 2), Vec2i(-3, 4)}) {
          const Ray ray = ray_of_pixel(optics, Vec2f(lens_centre(grid, lens.x, lens.y) + offset_px));
          const Vec3d from(ray.origin), to(ray.direction);
          const auto at = [&](double z) { return from + to * ((z - from.z) / to.z) - moved; };
          EXPECT_LT(glm::distance(at(800.0), camera.position_mm), 2e-3) << shift_mm << " " << view;
          const Vec2d pixel = projected(camera, at(0.0));
          EXPECT_LT(glm::distance(pixel, projected(camera, at(-700.0))), 2e-3) << shift_mm << " " << view;
          const double off_centre = glm::distance(pixel, glm::round(pixel - 0.5) + 0.5);
          if (packing == LensPacking::kSquare) {
            EXPECT_LT(off_centre, 2e-3);
          }
        }
      }
    }
}

TEST(PlenopticViews, views_coincide_in_the_plane_in_focus) {
  const Optics optics = plenoptic_optics(0.0f);
  const LightField field = views_of(optics, {9, 9});
  ASSERT_TRUE(field.cameras);
  EXPECT_NEAR(field.cameras->distance_mm, 800.0, 0.01);
  // Neighbouring views are pixel width * distance from main lens to lens array / gap = 0.01 * 53.333 / 2 mm apart on the main
  // lens.
  EXPECT_NEAR(field.cameras->eyes_mm[1].x - field.cameras->eyes_mm[0].x, 0.01 * (800.0 / 15.0) / 2.0, 1e-5);
  EXPECT_NEAR(field.cameras->eyes_mm[9].y - field.cameras->eyes_mm[0].y, 0.01 * (800.0 / 15.0) / 2.0, 1e-5);
  ASSERT_TRUE(field.depth);
  EXPECT_NEAR(field.depth->data[0], 0.0f, 0.01f);
}

TEST(PlenopticViews, cameras_of_other_grids_are_unknown) {
  const Optics optics = plenoptic_optics(0.0f);
  const Image raw(optics.panel.width, optics.panel.height, 3);
  LensGrid grid = lens_grid_of(optics).value();
  grid.rotation = 0.01;
  EXPECT_FALSE(plenoptic_views(raw, {.grid = grid, .optics = optics}, {3, 3}, raw, "a").cameras);
  const Image part(90, 135, 3);
  EXPECT_FALSE(plenoptic_views(part, {.grid = lens_grid_of(optics), .optics = optics}, {3, 3}, part, "a").cameras);
}

}  // namespace
}  // namespace lippmann

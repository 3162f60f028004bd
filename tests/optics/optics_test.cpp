#include "lippmann/optics/optics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

template <class Model>
Optics with(Model model, Panel panel = {}) {
  return {.panel = panel, .model = model};
}

TEST(WholePixels, defaults_have_eight_per_lens) {
  EXPECT_EQ(whole_pixels_per_lens(with(LenticularSheet{})), Vec2i(8, 1));
  EXPECT_EQ(whole_pixels_per_lens(with(MicrolensArray{})), Vec2i(8, 8));
}

TEST(WholePixels, views_count_as_one_pixel_each) {
  EXPECT_EQ(whole_pixels_per_lens(with(MultiView{})), Vec2i(1, 1));
  EXPECT_EQ(whole_pixels_per_lens(with(SingleView{})), Vec2i(1, 1));
}

TEST(WholePixels, fractions_slant_and_misaligned_cells_have_none) {
  EXPECT_EQ(whole_pixels_per_lens(with(LenticularSheet{.lens_pitch_mm = 13.776f * 0.125f})), Vec2i(0, 0));
  EXPECT_EQ(whole_pixels_per_lens(with(LenticularSheet{.slant = 0.1f})), Vec2i(0, 0));
  EXPECT_EQ(whole_pixels_per_lens(with(LenticularSheet{.offset_mm = 0.5625f})), Vec2i(0, 0));
  // A lens edge is at x = 0. The panel is 63 lenses wide, an odd number, so its left edge is not a lens edge.
  EXPECT_EQ(whole_pixels_per_lens(with(LenticularSheet{}, {504, 8, 0.125f})), Vec2i(0, 0));
  EXPECT_EQ(whole_pixels_per_lens(with(LenticularSheet{.offset_mm = 0.0f}, {504, 8, 0.125f})), Vec2i(8, 1));
}

TEST(WholePixels, converging_cells_count_by_their_own_width) {
  // For a viewer at 500 mm and a gap of 2 mm, the cell of pixels below a 1 mm lens is 1 + 2 / 500 = 1.004 mm or 8.032
  // pixels wide.
  EXPECT_EQ(whole_pixels_per_lens(with(LenticularSheet{.viewing_distance_mm = 500.0f})), Vec2i(0, 0));
  const LenticularSheet matched{.lens_pitch_mm = 1.0f / 1.004f, .offset_mm = 0.5f / 1.004f, .viewing_distance_mm = 500.0f};
  EXPECT_EQ(whole_pixels_per_lens(with(matched)), Vec2i(8, 1));
}

TEST(WholePixels, lens_and_view_follow_the_pixel_grid) {
  // Floats cannot represent the pitch of 0.7 mm exactly. In spite of rounding, pixel i must lie below lens floor(i /
  // N), with N pixels per lens.
  const Optics optics = with(LenticularSheet{.lens_pitch_mm = 0.7f, .gap_mm = 1.3f, .offset_mm = 0.35f}, {7000, 2, 0.1f});
  ASSERT_EQ(whole_pixels_per_lens(optics), Vec2i(7, 1));
  Optics at_lenses = optics;
  at_lenses.z_front_mm = 0.0f;
  for (int i = 0; i < 7000; ++i) {
    const double lens = 0.35 + 0.7 * (i / 7 - 500);
    EXPECT_NEAR(ray_of_pixel(at_lenses, {i + 0.5f, 0.5f}).origin.x, lens, 1e-4) << "pixel " << i;
  }
}

TEST(Derived, default_sheet_has_28_degrees_and_16mm) {
  // Viewing zone: 2 atan(pitch / (2 gap)) = 2 atan(1 / 4) = 28.07 degrees. Depth budget: pitch * gap / pixel = 1 * 2 /
  // 0.125 = 16 mm.
  EXPECT_NEAR(degrees(viewing_zone(with(LenticularSheet{}))), 28.0725f, 1e-3f);
  EXPECT_NEAR(depth_budget_mm(with(LenticularSheet{})), 16.0f, 1e-5f);
  EXPECT_EQ(depth_budget_mm(with(SingleView{})), kInfinity);
  EXPECT_EQ(viewing_zone(with(SingleView{})), 0.0f);
  EXPECT_EQ(viewing_zone(with(MultiView{.view_cone = 0.5f})), 0.5f);
}

TEST(Derived, slanted_panel_with_20_sub_pixels) {
  // A lens is 20 sub-pixels of 0.1 mm, or 2 mm, wide. The cone of 2 atan(1/2) contains 20 views, 1/20 mm apart per mm
  // of depth, so the depth budget is 2 / (1/20) = 40 mm. At a depth of 20 mm, a view covers 20 / 20 = 1 mm. At 4 mm, a
  // view covers less than a pixel, so the footprint is a pixel. Seen from 500 mm, pixels at depth z are scaled by 1 - z
  // / 500.
  const Optics panel = with(SlantedPanel{.periods = 30.0, .view_cone = 2.0f * std::atan(0.5f)}, {200, 100, 0.3f});
  EXPECT_NEAR(depth_budget_mm(panel), 40.0f, 1e-4f);
  EXPECT_EQ(viewing_zone(panel), 2.0f * std::atan(0.5f));
  EXPECT_EQ(whole_pixels_per_lens(panel), Vec2i(0, 0));
  EXPECT_NEAR(sample_footprint_mm(panel, -20.0f).x, 1.0f, 1e-6f);
  EXPECT_NEAR(sample_footprint_mm(panel, -20.0f).y, 0.3f * 1.04f, 1e-6f);
  EXPECT_NEAR(sample_footprint_mm(panel, 4.0f).x, 0.3f * 0.992f, 1e-6f);
  EXPECT_EQ(resolved_z_front_mm(panel), 500.0f);
}

TEST(Window, panel_or_one_view_of_a_quilt) {
  EXPECT_EQ(window_size_mm(with(LenticularSheet{}, {300, 200, 0.5f})), Vec2f(150.0f, 100.0f));
  EXPECT_EQ(window_size_mm(with(MultiView{.columns = 7, .rows = 3}, {300, 200, 0.5f})), Vec2f(21.0f, 33.0f));
  EXPECT_EQ(window_size_mm(with(MultiView{.columns = 7, .rows = 3, .pixel_height = 2.0f}, {300, 200, 0.5f})),
            Vec2f(21.0f, 66.0f));
  EXPECT_EQ(window_size_mm(with(SlantedPanel{}, {100, 200, 1.5f})), Vec2f(150.0f, 300.0f));
}

TEST(Footprint, lens_up_to_the_depth_budget) {
  const Optics sheet = with(LenticularSheet{});
  EXPECT_EQ(sample_footprint_mm(sheet, 0.0f), Vec2f(1.0f, 0.125f));
  EXPECT_EQ(sample_footprint_mm(sheet, -8.0f), Vec2f(1.0f, 0.125f));
  EXPECT_EQ(sample_footprint_mm(sheet, 32.0f), Vec2f(2.0f, 0.125f));
  EXPECT_EQ(sample_footprint_mm(sheet, -32.0f), Vec2f(2.0f, 0.125f));
  EXPECT_EQ(sample_footprint_mm(with(MicrolensArray{}), 32.0f), Vec2f(2.0f, 2.0f));
}

TEST(Footprint, of_a_view_shrinks_towards_the_eye) {
  const Optics view = with(SingleView{500.0f});
  EXPECT_EQ(sample_footprint_mm(view, 0.0f), Vec2f(0.125f));
  EXPECT_NEAR(sample_footprint_mm(view, 250.0f).x, 0.0625f, 1e-7f);
  EXPECT_NEAR(sample_footprint_mm(with(MultiView{}), -500.0f).y, 0.25f, 1e-7f);
}

TEST(Footprint, is_the_distance_between_neighbouring_rays) {
  const LenticularSheet matched{.lens_pitch_mm = 1.0f / 1.004f, .offset_mm = 0.5f / 1.004f, .viewing_distance_mm = 500.0f};
  for (const float z : {-10.0f, 10.0f}) {
    Optics optics = with(matched);
    optics.z_front_mm = z;
    const Vec3f a = ray_of_pixel(optics, {100.5f, 100.5f}).origin, b = ray_of_pixel(optics, {108.5f, 101.5f}).origin;
    const Vec2f footprint = sample_footprint_mm(optics, z);
    EXPECT_NEAR(b.x - a.x, footprint.x, 1e-5f);
    EXPECT_NEAR(a.y - b.y, footprint.y, 1e-5f);
  }
}

TEST(ZFront, infinite_means_the_eye_or_four_diagonals) {
  EXPECT_EQ(resolved_z_front_mm(with(SingleView{300.0f})), 300.0f);
  EXPECT_EQ(resolved_z_front_mm(with(LenticularSheet{.viewing_distance_mm = 700.0f})), 700.0f);
  EXPECT_NEAR(resolved_z_front_mm(with(MicrolensArray{}, {300, 400, 0.1f})), 200.0f, 1e-3f);
}

TEST(ZFront, views_never_start_behind_their_eye) {
  Optics sheet = with(LenticularSheet{}), view = with(SingleView{300.0f});
  sheet.z_front_mm = view.z_front_mm = 1000.0f;
  EXPECT_EQ(resolved_z_front_mm(sheet), 1000.0f);
  EXPECT_EQ(resolved_z_front_mm(view), 300.0f);
}

struct BadCase {
  const char* name;
  const char* field;
  Optics optics;
};

Optics bad_panel(int width, int height, float pitch) { return with(LenticularSheet{}, {width, height, pitch}); }

Optics with_depths(float front, float back) {
  Optics optics = with(LenticularSheet{});
  optics.z_front_mm = front, optics.z_back_mm = back;
  return optics;
}

constexpr Panel kSlantedPanel{171, 512, 0.15f};

Optics with_sub_pixel(Vec2f offset) {
  SlantedPanel slanted;
  slanted.sub_pixels[3][1][2] = offset;
  return with(slanted, kSlantedPanel);
}

void PrintTo(const BadCase& c, std::ostream* out) { *out << c.name; }

class BadOptics : public testing::TestWithParam<BadCase> {};

TEST_P(BadOptics, error_names_the_field) {
  try {
    validate(GetParam().optics);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), GetParam().field);
    EXPECT_FALSE(error.accepted().empty());
  }
}

const BadCase kBadCases[] = {
    {"parallax_nan", "multiview.parallax", with(MultiView{.parallax = std::nanf("")}, {480, 480, 0.1f})},
    {"parallax_of_a_sheet", "lenticular.parallax", with(LenticularSheet{.parallax = 0.0f})},
    {"parallax_of_lenslets", "microlens.parallax", with(MicrolensArray{.parallax = -1.0f})},
    {"parallax_of_a_panel", "slanted.parallax", with(SlantedPanel{.parallax = kInfinity}, kSlantedPanel)},
    {"eye_shift_nan", "multiview.eye_shift", with(MultiView{.eye_shift = {std::nanf(""), 0.0f}}, {480, 480, 0.1f})},
    {"baseline", "multiview.baseline_mm", with(MultiView{.baseline_mm = -1.0f}, {480, 480, 0.1f})},
    {"zero_width", "panel.width", bad_panel(0, 512, 0.1f)},
    {"negative_height", "panel.height", bad_panel(512, -4, 0.1f)},
    {"huge_width", "panel.width", bad_panel(1'000'000'000, 512, 0.1f)},
    {"too_many_pixels", "panel", bad_panel(65536, 65536, 0.1f)},
    {"zero_pixel_pitch", "panel.pixel_pitch_mm", bad_panel(512, 512, 0.0f)},
    {"nan_pixel_pitch", "panel.pixel_pitch_mm", bad_panel(512, 512, kNaN)},
    {"infinite_pixel_pitch", "panel.pixel_pitch_mm", bad_panel(512, 512, kInfinity)},
    {"zero_lens_pitch", "lenticular.lens_pitch_mm", with(LenticularSheet{.lens_pitch_mm = 0.0f})},
    {"lens_below_a_pixel", "lenticular.lens_pitch_mm", with(LenticularSheet{.lens_pitch_mm = 0.05f})},
    {"nan_lens_pitch", "lenticular.lens_pitch_mm", with(LenticularSheet{.lens_pitch_mm = kNaN})},
    {"negative_gap", "lenticular.gap_mm", with(LenticularSheet{.gap_mm = -1.0f})},
    {"slant_of_90_degrees", "lenticular.slant", with(LenticularSheet{.slant = kPi / 2})},
    {"nan_slant", "lenticular.slant", with(LenticularSheet{.slant = kNaN})},
    {"infinite_offset", "lenticular.offset_mm", with(LenticularSheet{.offset_mm = kInfinity})},
    {"zero_viewing_distance", "lenticular.viewing_distance_mm", with(LenticularSheet{.viewing_distance_mm = 0.0f})},
    {"negative_infinite_viewing_distance", "lenticular.viewing_distance_mm",
     with(LenticularSheet{.viewing_distance_mm = -kInfinity})},
    {"nan_eye_height", "lenticular.eye_height_mm", with(LenticularSheet{.eye_height_mm = kNaN})},
    {"zero_area_microlens", "microlens.lens_pitch_mm", with(MicrolensArray{.lens_pitch_mm = 0.0f})},
    {"zero_microlens_gap", "microlens.gap_mm", with(MicrolensArray{.gap_mm = 0.0f})},
    {"nan_microlens_offset", "microlens.offset_mm.y", with(MicrolensArray{.offset_mm = {0.0f, kNaN}})},
    {"nan_microlens_viewing_distance", "microlens.viewing_distance_mm", with(MicrolensArray{.viewing_distance_mm = kNaN})},
    {"no_columns", "multiview.columns", with(MultiView{.columns = 0})},
    {"more_rows_than_pixels", "multiview.rows", with(MultiView{.rows = 513})},
    {"cone_of_180_degrees", "multiview.view_cone", with(MultiView{.view_cone = kPi})},
    {"nan_cone", "multiview.view_cone", with(MultiView{.view_cone = kNaN})},
    {"negative_baseline", "multiview.baseline_mm", with(MultiView{.baseline_mm = -1.0f})},
    {"nan_baseline", "multiview.baseline_mm", with(MultiView{.baseline_mm = kNaN})},
    {"flat_pixels", "multiview.pixel_height", with(MultiView{.pixel_height = 0.0f})},
    {"zero_distance", "multiview.distance_mm", with(MultiView{.distance_mm = 0.0f})},
    {"infinite_distance", "singleview.distance_mm", with(SingleView{.distance_mm = kInfinity})},
    {"nan_pixel_offset", "singleview.pixel_offset", with(SingleView{.pixel_offset = {kNaN, 0.0f}})},
    {"no_lenses", "slanted.periods", with(SlantedPanel{.periods = 0.0}, kSlantedPanel)},
    {"nan_lenses", "slanted.periods", with(SlantedPanel{.periods = kNaN}, kSlantedPanel)},
    {"lenses_below_a_sub_pixel", "slanted.periods", with(SlantedPanel{.periods = 514.0}, kSlantedPanel)},
    {"infinite_tilt", "slanted.tilt", with(SlantedPanel{.tilt = kInfinity}, kSlantedPanel)},
    {"nan_center", "slanted.center", with(SlantedPanel{.center = kNaN}, kSlantedPanel)},
    {"slanted_cone_of_180_degrees", "slanted.view_cone", with(SlantedPanel{.view_cone = kPi}, kSlantedPanel)},
    {"slanted_zero_distance", "slanted.distance_mm", with(SlantedPanel{.distance_mm = 0.0f}, kSlantedPanel)},
    {"nan_sub_pixel", "slanted.sub_pixels", with_sub_pixel({0.0f, kNaN})},
    {"sub_pixel_far_away", "slanted.sub_pixels", with_sub_pixel({5.0f, 0.0f})},
    {"nan_z_front", "z_front_mm", with_depths(kNaN, kInfinity)},
    {"nan_z_back", "z_back_mm", with_depths(kInfinity, kNaN)},
    {"rays_without_length", "z_back_mm", with_depths(-20.0f, 10.0f)},
};

std::string name_of_case(const testing::TestParamInfo<BadCase>& bad) { return bad.param.name; }

INSTANTIATE_TEST_SUITE_P(Fields, BadOptics, testing::ValuesIn(kBadCases), name_of_case);

TEST(ValidateOptics, defaults_of_every_model_are_accepted) {
  EXPECT_NO_THROW(validate(with(LenticularSheet{})));
  EXPECT_NO_THROW(validate(with(MicrolensArray{})));
  EXPECT_NO_THROW(validate(with(MicrolensArray{.packing = LensPacking::kHexagonal})));
  EXPECT_NO_THROW(validate(with(MultiView{})));
  EXPECT_NO_THROW(validate(with(SingleView{})));
  EXPECT_NO_THROW(validate(with(SlantedPanel{}, kSlantedPanel)));
}

TEST(ValidateOptics, accepts_one_pixel_and_one_pixel_lenses) {
  EXPECT_NO_THROW(validate(with(SingleView{}, {1, 1, 1.0f})));
  EXPECT_NO_THROW(validate(with(LenticularSheet{.lens_pitch_mm = 0.1f}, {512, 512, 0.1f})));
}

}  // namespace
}  // namespace lippmann

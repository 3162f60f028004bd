#include "stage/depth_budget.hpp"

#include <gmock/gmock.h>

#include "job/optics_on.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

FittedArray array_of_depth(float half_depth) {
  FittedArray array;
  array.plane_height = 6.4f;
  array.viewing_distance = 20.0f;
  array.depth_front = half_depth, array.depth_back = -half_depth;
  return array;
}

std::string budget_for(float half_depth) {
  const Optics optics{.panel = {}, .model = LenticularSheet{}};
  return depth_budget_sentence(shown_depth(array_of_depth(half_depth), 0.1f, 1.0f, optics), optics);
}

TEST(DepthBudget, scene_within_it_is_reported) {
  EXPECT_EQ(budget_for(1.5f),
            "The scene reaches from -15.0 mm to +15.0 mm, within the depth budget of 16.0 mm on either side.");
}

TEST(DepthBudget, excess_of_a_deep_scene_is_reported) {
  EXPECT_EQ(budget_for(4.0f),
            "The scene reaches from -40.0 mm to +40.0 mm, 24.0 mm beyond the depth budget of 16.0 mm on either "
            "side: at 40.0 mm a pixel is as wide as 2.5 lenses.");
}

TEST(DepthBudget, single_view_has_no_budget) {
  const Optics optics{.panel = {}, .model = SingleView{}};
  EXPECT_THAT(depth_budget_sentence(shown_depth(FittedArray{}, 1.0f, 1.0f, optics), optics), HasSubstr("no depth budget"));
}

TEST(DepthBudget, views_are_a_pixel_apart_at_it) {
  // By similar triangles, an eye at x = e and 500 mm sees a point (0, z) at -z e / (500 - z) in the plane z = 0. Two
  // views 20 degrees apart have eyes at e = -+500 tan(10 degrees) = -+88.163 mm. The positions are 2 z * 88.163 / (500
  // - z) apart: one pixel of 0.5 mm for z = 1.4138 mm.
  const Optics optics{.panel = {200, 100, 0.5f}, .model = MultiView{2, 1, radians(40.0f), false, 500.0f}};
  EXPECT_NEAR(depth_budget_mm(optics), 1.4138f, 1e-4f);
  std::vector<Vec2f> pixels;
  pixels_seeing(optics, {0.0f, 0.0f, depth_budget_mm(optics)}, pixels);
  ASSERT_EQ(pixels.size(), 2u);
  EXPECT_NEAR((pixels[0].x - 0.0f) - (pixels[1].x - 100.0f), 1.0f, 1e-3f);
}

RenderParams fitted_depth() {
  RenderParams params;
  params.optics.fit_depth = true;
  params.optics.view_angle_deg = 28.0f;
  return params;
}

TEST(FitDepth, deep_scene_is_scaled_to_the_budget) {
  const PlacedOptics placed = test::optics_on(array_of_depth(4.0f), fitted_depth());
  const ShownDepth shown = shown_depth(array_of_depth(4.0f), placed.units_per_mm, placed.depth_scale, placed.optics);
  EXPECT_NEAR(shown.deepest_mm(), shown.budget_mm, 1e-3f * shown.budget_mm);
  EXPECT_LT(placed.depth_scale, 0.5f);
}

TEST(FitDepth, is_the_default_of_lenses_and_displays) {
  const auto scale = [](const RenderParams& params, const char* display = nullptr) {
    const std::optional<Display> loaded = display ? std::optional(load_display(display)) : std::nullopt;
    return test::optics_on(array_of_depth(40.0f), params, loaded ? &*loaded : nullptr).depth_scale;
  };
  RenderParams params;
  EXPECT_LT(scale(params), 0.1f) << "a lenticular sheet";
  params.optics.kind = OpticsKind::kMultiview;
  EXPECT_EQ(scale(params), 1.0f) << "views of no display";
  params.optics.camera_grid = true;
  EXPECT_EQ(scale(params), 1.0f) << "a camera grid";
  params = {};
  params.optics.kind = OpticsKind::kSingle;
  EXPECT_EQ(scale(params), 1.0f) << "a single view";
  params = {};
  params.optics.display = "portrait";
  EXPECT_LT(scale(params, "portrait"), 0.5f) << "the quilt of a display";
  params.optics.fit_depth = false;
  EXPECT_EQ(scale(params, "portrait"), 1.0f);
}

TEST(FitDepth, report_has_factor_and_true_depth) {
  const Optics optics{.panel = {}, .model = LenticularSheet{}};
  EXPECT_EQ(
      depth_budget_sentence(shown_depth(array_of_depth(4.0f), 0.1f, 0.4f, optics), optics, 0.4f),
      "The scene reaches from -40.0 mm to +40.0 mm, beyond the depth budget of 16.0 mm on either side. Its depth is scaled to "
      "40 %: -16.0 mm to +16.0 mm.");
}

TEST(FitDepth, scene_that_fits_is_unchanged) {
  EXPECT_EQ(test::optics_on(array_of_depth(0.5f), fitted_depth()).depth_scale, 1.0f);
}

TEST(FitDepth, optics_do_not_depend_on_depth) {
  RenderParams plain = fitted_depth();
  plain.optics.fit_depth = false;
  ASSERT_EQ(test::optics_on(array_of_depth(4.0f), plain).depth_scale, 1.0f);
  const auto gap = [](const RenderParams& params) {
    return std::get<LenticularSheet>(test::optics_on(array_of_depth(4.0f), params).optics.model).gap_mm;
  };
  EXPECT_EQ(gap(fitted_depth()), gap(plain));
}

TEST(FitDepth, middle_of_the_zone_is_unchanged) {
  // The parallax of 0.5 halves the slopes of rays. A single lens covers all 512 pixels.
  Optics optics{.panel = {512, 1, 0.125f},
                .model = LenticularSheet{.lens_pitch_mm = 64.0f, .gap_mm = 100.0f, .offset_mm = 0.0f}};
  for (const auto& [pixel, slope] : {std::pair(256.0f, 0.0f), std::pair(264.0f, -0.01f)}) {
    const Ray ray = ray_of_pixel(with_parallax(optics, 0.5f), {pixel, 0.5f});
    EXPECT_NEAR(ray.direction.x / ray.direction.z, 0.5f * slope, 1e-6f);
    EXPECT_NEAR(ray.origin.x + ray.direction.x * (-ray.origin.z / ray.direction.z), 0.0f, 1e-4f);
  }
}

TEST(FitDepth, quilt_eyes_move_together) {
  // Two views 20 degrees apart at 500 mm have eyes at -+500 tan(10 degrees) = -+88.163 mm, times the parallax.
  const Optics quilt{.panel = {200, 100, 0.5f}, .model = MultiView{2, 1, radians(40.0f), false, 500.0f}};
  for (const float parallax : {1.0f, 0.25f}) {
    const Ray ray = ray_of_pixel(with_parallax(quilt, parallax), {50.0f, 50.0f});
    const float at_eye = ray.origin.x + ray.direction.x * ((500.0f - ray.origin.z) / ray.direction.z);
    EXPECT_NEAR(at_eye, -parallax * 88.163f, 1e-3f);
  }
}

}  // namespace
}  // namespace lippmann

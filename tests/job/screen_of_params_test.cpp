#include "job/screen_of_params.hpp"

#include <gtest/gtest.h>

#include "job/optics_on.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {
namespace {

using test::optics_on;

FittedArray placed_array() {
  FittedArray array;
  array.plane_height = 8.0f;
  array.viewing_distance = 24.0f;
  return array;
}

TEST(ScreenOfParams, default_gap_follows_the_viewing_angle) {
  RenderParams params;
  params.optics.viewing_distance_mm = kInfinity;
  const Optics optics = optics_on(placed_array(), params).optics;
  const auto& sheet = std::get<LenticularSheet>(optics.model);
  EXPECT_FLOAT_EQ(optics.panel.pixel_pitch_mm, 0.125f);
  EXPECT_FLOAT_EQ(sheet.lens_pitch_mm, 1.0f);
  EXPECT_NEAR(sheet.gap_mm, 2.00539f, 1e-4f);  // gap: pitch / (2 tan(zone / 2)) = 1 mm / (2 tan(14 degrees))
  EXPECT_NEAR(degrees(viewing_zone(optics)), 28.0f, 1e-4f);
  EXPECT_EQ(whole_pixels_per_lens(optics), Vec2i(8, 1));
}

TEST(ScreenOfParams, panel_is_scaled_to_the_fitted_plane) {
  const PlacedOptics placed = optics_on(placed_array(), {});
  EXPECT_FLOAT_EQ(placed.units_per_mm, 8.0f / 64.0f);
  EXPECT_FLOAT_EQ(std::get<LenticularSheet>(placed.optics.model).viewing_distance_mm, 24.0f * 64.0f / 8.0f);
  EXPECT_FLOAT_EQ(resolved_z_front_mm(placed.optics), 192.0f) << "rays start at the viewer";
}

TEST(ScreenOfParams, quilt_view_fills_the_fitted_plane) {
  RenderParams params;
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {4, 3};
  params.optics.size = {400, 300};
  const PlacedOptics placed = optics_on(placed_array(), params);
  const float view_height_mm = 100.0f * placed.optics.panel.pixel_pitch_mm;
  EXPECT_FLOAT_EQ(placed.units_per_mm * view_height_mm, 8.0f);
  EXPECT_FLOAT_EQ(std::get<MultiView>(placed.optics.model).distance_mm * placed.units_per_mm, 24.0f);
}

RenderParams plenoptic_params() {
  RenderParams params;
  params.optics.kind = OpticsKind(plenoptic_kind);
  return params;
}

/// The scene is in metres. The plane at 24,000 mm is 8,000 mm high; its image, 108 mm behind the main lens, is 36 mm
/// high.
TEST(ScreenOfParams, plenoptic_camera_sees_the_fitted_plane) {
  const PlacedOptics placed = optics_on(placed_array(), plenoptic_params());
  const auto& camera = std::get<PlenopticCamera>(placed.optics.model);
  EXPECT_FLOAT_EQ(placed.units_per_mm, 1e-3f);
  EXPECT_FLOAT_EQ(camera.distance_mm, 24000.0f);
  EXPECT_FLOAT_EQ(window_size_mm(placed.optics).y, 8000.0f);
  EXPECT_NEAR(1.0 / camera.focal_length_mm, 1.0 / (108.0 - camera.gap_mm) + 1.0 / 24000.0, 1e-8);
  EXPECT_FLOAT_EQ(placed.optics.panel.pixel_pitch_mm, 36.0f / 512.0f);
}

TEST(ScreenOfParams, plenoptic_camera_stays_in_its_place) {
  RenderParams params = plenoptic_params();
  params.optics.viewing_distance_mm = 300.0f;
  const Scene scene = load_scene("room", {}, Context{});
  const PlacedJob fitted = place(ResolvedJob(params), scene);
  params.optics.focal_length_mm = 100.0f;
  const PlacedJob longer = place(ResolvedJob(params), scene);
  EXPECT_FLOAT_EQ(longer.placed.units_per_mm * 300.0f, longer.array.viewing_distance);
  EXPECT_FLOAT_EQ(longer.placed.units_per_mm, fitted.placed.units_per_mm);
  // distance from the main lens to the sensor: 1 / (1 / 100 - 1 / 300) = 150 mm
  const float sensor_mm = 150.0f + std::get<PlenopticCamera>(longer.placed.optics.model).gap_mm;
  EXPECT_FLOAT_EQ(longer.array.plane_height / longer.array.viewing_distance, 36.0f / sensor_mm);
}

TEST(ScreenOfParams, camera_grid_divides_the_viewing_zone) {
  RenderParams params;
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {9, 5};
  params.optics.size = {900, 500};
  params.optics.camera_grid = true;
  params.optics.view_angle_deg = 30.0f;
  const Optics optics = optics_on(placed_array(), params).optics;
  const auto& views = std::get<MultiView>(optics.model);
  EXPECT_FLOAT_EQ(views.baseline_mm, 2.0f * views.distance_mm * std::tan(radians(15.0f)) / 9.0f);
  EXPECT_NEAR(degrees(viewing_zone(optics)), 30.0f, 1e-4f);
}

TEST(ScreenOfParams, whole_cells_stay_aligned_with_pixels) {
  for (const int lenses : {1, 7, 64})
    for (const float distance : {50.0f, 192.0f, kInfinity}) {
      RenderParams params;
      params.optics.lenses = {lenses, 0};
      params.optics.lens_pixels = {6.0f, 0.0f};
      params.optics.viewing_distance_mm = distance;
      EXPECT_EQ(whole_pixels_per_lens(optics_on(placed_array(), params).optics), Vec2i(6, 1))
          << lenses << " lenses, viewed from " << distance;
      params.optics.kind = OpticsKind::kMicrolens;
      EXPECT_EQ(whole_pixels_per_lens(optics_on(placed_array(), params).optics), Vec2i(6, 6))
          << lenses << " lenslets, viewed from " << distance;
    }
}

TEST(ScreenOfParams, slanted_pixels_count_along_the_rows) {
  RenderParams params;
  params.optics.slant_deg = 60.0f;
  params.optics.viewing_distance_mm = kInfinity;
  const Optics optics = optics_on(placed_array(), params).optics;
  EXPECT_NEAR(std::get<LenticularSheet>(optics.model).lens_pitch_mm, 8.0f * optics.panel.pixel_pitch_mm * 0.5f, 1e-6f);
}

TEST(ScreenOfParams, viewer_too_close_for_lenses_is_refused) {
  for (const OpticsKind kind : {OpticsKind::kLenticular, OpticsKind::kMicrolens}) {
    RenderParams params;
    params.optics.kind = kind;
    // The viewer is 0.1 mm in front of the lenses, and the panel 2 mm behind them. Lenses would thus be 0.1 / (0.1 + 2) = 1/21
    // as wide as the parts of the panel below them.
    params.optics.viewing_distance_mm = 0.1f;
    try {
      optics_on(placed_array(), params);
      FAIL() << "accepted";
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("--viewing-distance")) << error.what();
    }
  }
}

TEST(ScreenOfParams, infinite_viewer_needs_lenses) {
  RenderParams params;
  params.optics.kind = OpticsKind::kSingle;
  params.optics.viewing_distance_mm = kInfinity;
  EXPECT_THROW(optics_on(placed_array(), params), Error);
}

TEST(ScreenOfParams, single_view_has_a_finite_viewer) {
  RenderParams params;
  params.optics.kind = OpticsKind::kSingle;
  FittedArray array = placed_array();
  array.viewing_distance = kInfinity;
  EXPECT_FLOAT_EQ(std::get<SingleView>(optics_on(array, params).optics.model).distance_mm, 3.0f * 64.0f);
}

TEST(ScreenOfParams, single_view_takes_the_cameras_pixel_offset) {
  RenderParams params;
  params.optics.kind = OpticsKind::kSingle;
  Scene scene;
  scene.cameras.push_back({});
  scene.cameras[0].pixel_offset = {0.5f, -0.5f};
  EXPECT_EQ(std::get<SingleView>(optics_on(placed_array(), params, nullptr, scene).optics.model).pixel_offset,
            Vec2f(0.5f, -0.5f));
}

TEST(ScreenOfParams, single_view_is_shifted_by_heights_of_its_picture) {
  RenderParams params;
  params.optics.kind = OpticsKind::kSingle;
  params.optics.size = {400, 200};
  Scene scene;
  scene.cameras.push_back({});
  scene.cameras[0].shift = {0.25f, -0.5f};
  EXPECT_EQ(std::get<SingleView>(optics_on(placed_array(), params, nullptr, scene).optics.model).pixel_offset,
            Vec2f(50.0f, 100.0f));
}

}  // namespace
}  // namespace lippmann

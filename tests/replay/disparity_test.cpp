#include "lippmann/replay/disparity.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "formats/stated_cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/replay/light_field_frames.hpp"
#include "lippmann/replay/refocus.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

constexpr Vec2i kViewSize{480, 360};

double wave_at(double x, double y) {
  return 0.5 + 0.2 * std::sin(2.0 * M_PI * x / 29.0) * std::sin(2.0 * M_PI * y / 37.0) +
         0.15 * std::sin(2.0 * M_PI * (x + y) / 51.0);
}

/// 5 x 5 parallel cameras see a plane that moves by `disparity_px` pixels between neighbouring views.
LightField plane_seen(double disparity_px) {
  LightField field;
  field.grid = {5, 5}, field.view_size = kViewSize;
  field.aspect = static_cast<double>(kViewSize.x) / kViewSize.y;
  Image stack(kViewSize.x, kViewSize.y * 25, 3);
  for (int view = 0; view < 25; ++view)
    for (int y = 0; y < kViewSize.y; ++y)
      for (int x = 0; x < kViewSize.x; ++x) {
        // From an eye further right and up, the plane appears further left and down.
        const double u = x + disparity_px * (view % 5 - 2), v = y - disparity_px * (view / 5 - 2);
        const auto grey = static_cast<float>(wave_at(u, v));
        float* pixel = stack.pixel(x, view * kViewSize.y + y);
        pixel[0] = pixel[1] = pixel[2] = grey;
      }
  field.stack = std::move(stack);
  return field;
}

double psnr_of_plane(const Image& picture) {
  double squares = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) squares += std::pow(picture.pixel(x, y)[0] - wave_at(x, y), 2);
  return -10.0 * std::log10(squares / (picture.width * picture.height));
}

// Disparity in pixels: focal length / pixel pitch * baseline / distance.
constexpr double kTrialPx = 8.0 / 0.0024 * 6.25 / 130.0;

TEST(Disparity, near_plane_is_refocused) {
  EXPECT_NEAR(kTrialPx, 160.3, 0.05);
  const LightField field = plane_seen(kTrialPx);
  const Optics optics = assumed_optics(field, std::nullopt);
  const RenderedPanel panel = panel_of(field, optics, "plane");
  const ThreadPool pool(2);
  const double z_mm = depth_of_disparity_px(optics, 160.3, "refocus");
  validate_depth(optics, z_mm, "refocus");
  EXPECT_GT(psnr_of_plane(refocus(panel, z_mm, kViewSize, pool)), 35.0);
  const double other_mm = depth_of_disparity_px(optics, 150.0, "refocus");
  EXPECT_LT(psnr_of_plane(refocus(panel, other_mm, kViewSize, pool)), 25.0);
}

TEST(Disparity, near_plane_is_refocused_before_a_very_distant_panel) {
  constexpr double kPanel_mm = 1e6, kPx = kTrialPx * (1.0 - 130.0 / kPanel_mm);
  LightField field = plane_seen(kPx);
  const StatedCameras stated{
      .baseline_mm = 6.25, .focal_length_mm = 8.0, .sensor_width_mm = 0.0024 * kViewSize.x, .focus_distance_mm = kPanel_mm};
  field.cameras = cameras_as_stated(stated, field, "a");
  const Optics optics = optics_of_cameras(field, "a");
  const double z_mm = depth_of_disparity_px(optics, kPx, "refocus");
  EXPECT_NEAR(z_mm, kPanel_mm - 130.0, 0.1);
  validate_depth(optics, z_mm, "refocus");
  const ThreadPool pool(2);
  EXPECT_GT(psnr_of_plane(refocus(panel_of(field, optics, "plane"), z_mm, kViewSize, pool)), 35.0);
}

TEST(Disparity, depth_agrees_with_stated_cameras) {
  LightField field = plane_seen(0.0);
  const StatedCameras stated{
      .baseline_mm = 100.0, .focal_length_mm = 100.0, .sensor_width_mm = 35.0, .focus_distance_mm = 8000.0};
  field.cameras = cameras_as_stated(stated, field, "a");
  const Optics optics = optics_of_cameras(field, "a");
  const double at_4_m = 100.0 * 100.0 * kViewSize.x / 35.0 * (1.0 / 4000.0 - 1.0 / 8000.0);
  EXPECT_NEAR(depth_of_disparity_px(optics, at_4_m, "refocus"), 4000.0, 0.01);
  EXPECT_NEAR(depth_of_disparity_px(optics, 0.0, "refocus"), 0.0, 1e-9);
  EXPECT_LT(depth_of_disparity_px(optics, -0.999 * at_4_m, "refocus"), -1e6);
}

TEST(Disparity, points_beyond_infinity_are_refused) {
  const Optics optics = assumed_optics(plane_seen(0.0), std::nullopt);
  for (const double bad : {-1e6, std::nan(""), static_cast<double>(INFINITY)})
    EXPECT_THAT(error_message([&] { depth_of_disparity_px(optics, bad, "refocus"); }), HasSubstr("infinity")) << bad;
}

TEST(Disparity, parallel_projections_have_no_disparity) {
  const Optics optics{.panel = {40, 40, 0.1f}, .model = MicrolensArray{}};
  EXPECT_THAT(error_message([&] { depth_of_disparity_px(optics, 1.0, "refocus"); }), HasSubstr("refocus"));
}

}  // namespace
}  // namespace lippmann

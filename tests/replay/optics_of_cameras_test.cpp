#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lippmann/formats/formats.hpp"
#include "lippmann/optics/view_cameras.hpp"
#include "lippmann/replay/light_field_frames.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

LightField field_of_grid(float eye_height_mm) {
  MultiView views{.columns = 3, .rows = 1, .distance_mm = 300.0f};
  views.baseline_mm = 12.0f, views.eye_height_mm = eye_height_mm;
  LightField field;
  field.grid = {3, 1}, field.view_size = {40, 30};
  field.cameras = view_cameras({.panel = {120, 30, 0.5f}, .model = views});
  return field;
}

TEST(OpticsOfCameras, height_of_the_cameras_is_kept) {
  for (const float height : {0.0f, 90.0f, -17.5f}) {
    const Optics optics = optics_of_cameras(field_of_grid(height), "cameras.json");
    const auto& views = std::get<MultiView>(optics.model);
    EXPECT_FLOAT_EQ(views.eye_height_mm, height);
    EXPECT_FLOAT_EQ(views.baseline_mm, 12.0f);
    EXPECT_NEAR(ray_of_pixel(optics, {20.0f, 15.0f}).origin.y, height, 1e-4f);
  }
}

TEST(OpticsOfCameras, off_centre_cameras_are_refused) {
  LightField field = field_of_grid(0.0f);
  for (Vec2d& eye : field.cameras->eyes_mm) eye.x += 30.0;
  EXPECT_THAT(test::error_message([&] { optics_of_cameras(field, "cameras.json"); }), HasSubstr("60 pixels off centre"));
}

TEST(OpticsOfCameras, quilt_keeps_a_grid_of_cameras) {
  const test::TempDir dir;
  LightField field;
  field.grid = {4, 3}, field.view_size = {8, 6};
  field.stack = Image8{8, 6 * 12, std::vector<unsigned char>(3 * 8 * 6 * 12, 99)};
  const std::filesystem::path quilt = quilt_format().write(field, dir / "q.png", {}).front();
  const Optics optics = find_light_field_frames(quilt, {}).optics;
  const auto& views = std::get<MultiView>(optics.model);
  EXPECT_EQ(views.columns, 4);
  EXPECT_EQ(views.rows, 3);
  EXPECT_GT(views.baseline_mm, 0.0f);
}

}  // namespace
}  // namespace lippmann

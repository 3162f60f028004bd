#include <gmock/gmock.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "formats/cvkit_camera.hpp"
#include "image/netpbm.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message, test::numbered_field, test::same_samples, test::TempDir;
using testing::HasSubstr;

/// Returns views of two eyes 20 mm apart, 500 mm in front of a plane in which pixels are 0.5 mm wide.
LightField cvkit_field() {
  LightField field = numbered_field({2, 1}, {40, 30});
  field.cameras = {500.0, Vec2d(0.5), Vec2d(20.0, 15.0), {{-10.0, 6.0}, {10.0, 6.0}}};
  field.depth = Image(40, 60, 1);
  for (std::size_t i = 0; i < field.depth->data.size(); ++i) field.depth->data[i] = i % 5 == 0 ? -INFINITY : 0.25f * (i % 100);
  return field;
}

constexpr const char* kByHand =
    "camera.A=[1000 0 40; 0 1000 3; 0 0 1]\ncamera.R=[1 0 0; 0 1 0; 0 0 1]\ncamera.T=[0.01 -0.006 0]\n"
    "camera.width=40\ncamera.height=30\nrho=20\nt=0.02\n";

TEST(CvkitCamera, text_is_as_worked_by_hand) {
  const MivCamera right = miv_cameras(*cvkit_field().cameras, {40, 30}, {"a", "b"}, 0.25, 2.0)[1];
  EXPECT_EQ(cvkit_camera_text({right, 20.0}), kByHand);
  const CvkitCamera read = parse_cvkit_camera(kByHand, "a");
  EXPECT_EQ(read.rho, 20.0);
  EXPECT_EQ(read.camera.principal_point_px, Vec2d(40.0, 3.0));
  EXPECT_EQ(cvkit_camera_text(read), kByHand);
}

TEST(CvkitCamera, only_matrix_is_required) {
  const CvkitCamera read = parse_cvkit_camera("# by another tool\r\ncamera.A=[ 500.5 0 320; 0 500.5 240; 0 0 1 ]\r\n", "a");
  EXPECT_EQ(read.camera.focal_px, Vec2d(500.5));
  EXPECT_EQ(read.camera.resolution, Vec2i(0));
  EXPECT_EQ(read.rho, 0.0);
}

TEST(CvkitCamera, damaged_files_are_refused) {
  const std::string a = "camera.A=[1 0 1; 0 1 1; 0 0 1]\n";
  for (const std::string& text :
       {std::string(), std::string("camera.A=[1 0 1; 0 1 1]\n"), std::string("camera.A=[1 0 1; 0 nan 1; 0 0 1]\n"),
        std::string("camera.A=[1 2 1; 0 1 1; 0 0 1]\n"), std::string("camera.A=[-1 0 1; 0 1 1; 0 0 1]\n"),
        a + "camera.R=[0 1 0; 1 0 0; 0 0 1]\n", a + "camera.T=[1 2]\n", a + "camera.k1=0.1\n", a + "camera.width=-3\n",
        a + "camera.height=2.5\n", a + "rho=-1\n", a + "rho=x\n", a + "t=nan\n", a + "camera.T=[0 nan 0]\n",
        a + "camera.width=inf\n"})
    EXPECT_THAT(error_message([&] { parse_cvkit_camera(text, "v_param.txt"); }), HasSubstr("v_param.txt")) << text;
}

TEST(CvkitFormat, cameras_and_depth_come_back) {
  const TempDir dir;
  const LightField field = cvkit_field();
  cvkit_format().write(field, dir / "a", {});
  // Focal length: f = 500 mm / 0.5 mm = 1000 px. The point at z = 24.5 mm is Z = 475.5 mm from the eyes. Disparity: f b
  // / Z = 1000 px * 20 mm / 475.5 mm.
  EXPECT_NEAR(read_pfm(dir / "a/view_000_disp.pfm").pixel(18, 2)[0], 20000.0 / (500.0 - 0.25 * 98), 1e-4);
  const OpenedLightField read = open_light_field(dir / "a", "", {});
  EXPECT_EQ(read.format, "cvkit");
  EXPECT_TRUE(same_samples(read.field.stack, field.stack));
  ASSERT_TRUE(read.field.cameras && read.field.depth);
  EXPECT_NEAR(read.field.cameras->distance_mm, 500.0, 1e-9);
  for (std::size_t view = 0; view < 2; ++view)
    EXPECT_LT(glm::distance(read.field.cameras->eyes_mm[view], field.cameras->eyes_mm[view]), 1e-9);
  for (std::size_t i = 0; i < field.depth->data.size(); ++i)
    if (std::isinf(field.depth->data[i]))
      ASSERT_EQ(read.field.depth->data[i], -INFINITY);
    else
      ASSERT_NEAR(read.field.depth->data[i], field.depth->data[i], 1e-3);
}

TEST(CvkitFormat, rectified_pairs_keep_poses_and_depth) {
  const TempDir dir;
  cvkit_format().write(cvkit_field(), dir / "a", {});
  for (const int view : {0, 1})
    std::ofstream(dir / fmt::format("a/view_00{}_param.txt", view))
        << "camera.A=[1000 0 20; 0 1000 15; 0 0 1]\nrho=20\ncamera.T=[" << 0.02 * view << " 0 0]\n";
  const LightField read = cvkit_format().read(dir / "a", {});
  EXPECT_FALSE(read.cameras);
  ASSERT_TRUE(read.poses && read.depth);
  EXPECT_EQ((*read.poses)[1].position_mm, Vec3d(20.0, 0.0, 0.0));
  EXPECT_EQ((*read.poses)[1].size, Vec2i(40, 30));
  // Pixel 1 of cvkit_field() is 0.25 mm in front of the plane, which is 500 mm from the eyes.
  EXPECT_NEAR(read.depth->data[1], -(500.0 - 0.25), 1e-3) << "z in the camera's frame";
}

TEST(CvkitFormat, files_that_disagree_are_refused) {
  const TempDir dir;
  const LightField field = cvkit_field();
  EXPECT_THAT(error_message([&] {
                cvkit_format().write(numbered_field({2, 1}, {4, 4}), dir / "x", {});
              }),
              HasSubstr("cameras"));
  cvkit_format().write(field, dir / "a", {});
  EXPECT_THAT(error_message([&] { cvkit_format().read(dir / "a", {.views = ViewGrid{3, 1}}); }), HasSubstr("2 views"));
  std::ofstream(dir / "a/view_001_param.txt") << "camera.A=[1000 0 40; 0 1000 3; 0 0 1]\ncamera.T=[0.01 -0.006 0]\n"
                                                 "camera.width=41\ncamera.height=30\n";
  EXPECT_THAT(error_message([&] { cvkit_format().read(dir / "a", {}); }), HasSubstr("41 and 30"));
  fs::remove(dir / "a/view_001.png");
  EXPECT_THAT(error_message([&] { cvkit_format().read(dir / "a", {}); }), HasSubstr("view_001_param.txt is missing"));
}

}  // namespace
}  // namespace lippmann

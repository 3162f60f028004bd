#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "formats/miv_cameras.hpp"
#include "layout/cameras.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::numbered_field;
using test::same_samples;
using test::TempDir;
using testing::AllOf;
using testing::HasSubstr;

/// Returns views of two eyes 20 mm apart, 500 mm in front of a plane in which pixels are 0.5 mm wide.
LightField two_views() {
  LightField field = numbered_field({2, 1}, {40, 30});
  field.cameras = {500.0, Vec2d(0.5), Vec2d(20.0, 15.0), {{-10.0, 6.0}, {10.0, 6.0}}};
  return field;
}

std::vector<MivCamera> cameras_by_hand() { return miv_cameras(*two_views().cameras, {40, 30}, {"a", "b"}, 0.25, 2.0); }

TEST(MivCameras, positions_in_metres_with_shifted_sensors) {
  const MivCamera right = cameras_by_hand()[1];
  EXPECT_EQ(right.position_m[0], 0.0);
  EXPECT_DOUBLE_EQ(right.position_m[1], -0.01) << "10 mm to the right";
  EXPECT_DOUBLE_EQ(right.position_m[2], 0.006) << "6 mm up";
  EXPECT_EQ(right.focal_px, Vec2d(1000.0)) << "500 mm / 0.5 mm";
  EXPECT_EQ(right.principal_point_px, Vec2d(20.0 + 20.0, 15.0 - 12.0)) << "straight ahead of the eye: 20 pixels right, 12 up";
}

TEST(MivCameras, text_brings_back_cameras) {
  const std::string text = miv_cameras_text(cameras_by_hand(), "room", true);
  const std::vector<MivCamera> back = parse_miv_cameras(text, "a");
  EXPECT_EQ(miv_cameras_text(back, "room", true), text);
  const ViewCameras cameras = cameras_of_miv(back).value(), original = *two_views().cameras;
  EXPECT_NEAR(cameras.distance_mm, 500.0, 1e-9);
  EXPECT_NEAR(cameras.pixel_mm.x, 0.5, 1e-12);
  EXPECT_LT(glm::distance(cameras.centre_px, original.centre_px), 1e-9);
  for (std::size_t view = 0; view < 2; ++view) EXPECT_LT(glm::distance(cameras.eyes_mm[view], original.eyes_mm[view]), 1e-9);
}

TEST(MivCameras, text_has_the_fields_that_tmiv_requires) {
  const nlohmann::json json = nlohmann::json::parse(miv_cameras_text(cameras_by_hand(), "room", true));
  for (const char* key :
       {"Version", "Content_name", "BoundingBox_center", "Fps", "Frames_number", "lengthsInMeters", "cameras"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["Frames_number"], 1);
  EXPECT_EQ(json["cameras"][0]["BitDepthColor"], 10) << "TMIV reads textures of 10 bits";
}

TEST(MivCameras, rotated_cameras_share_no_window) {
  std::vector<MivCamera> turned = cameras_by_hand(), unshifted = cameras_by_hand();
  turned[1].rotation_deg[0] = 1.0;
  unshifted[1].principal_point_px = unshifted[0].principal_point_px;
  EXPECT_FALSE(cameras_of_miv(turned));
  EXPECT_FALSE(cameras_of_miv(unshifted));
}

TEST(MivCameras, angles_are_yaw_pitch_and_roll) {
  const auto rotation_by = [](int angle) {
    LightField field;
    std::vector<MivCamera> cameras = cameras_by_hand();
    cameras[1].rotation_deg[angle] = 90.0;
    set_cameras(cameras, field);
    EXPECT_EQ(field.poses->front().rotation, glm::dmat3(1.0));
    return field.poses->back().rotation;  // columns: right, up, back
  };
  const auto expect_columns = [](const glm::dmat3& rotation, Vec3d right, Vec3d up, Vec3d back) {
    EXPECT_LT(glm::distance(rotation[0], right), 1e-12);
    EXPECT_LT(glm::distance(rotation[1], up), 1e-12);
    EXPECT_LT(glm::distance(rotation[2], back), 1e-12);
  };
  expect_columns(rotation_by(0), {0, 0, -1}, {0, 1, 0}, {1, 0, 0});  // looks to the left
  expect_columns(rotation_by(1), {1, 0, 0}, {0, 0, -1}, {0, 1, 0});  // looks down
  expect_columns(rotation_by(2), {0, -1, 0}, {1, 0, 0}, {0, 0, 1});  // leans to the right
}

TEST(MivFormat, cameras_without_a_common_window_keep_poses) {
  const TempDir dir;
  LightField field = two_views();
  field.depth = Image(40, 60, 1);
  for (float& z : field.depth->data) z = -500.0f;
  miv_format().write(field, dir / "m", {});
  std::vector<MivCamera> cameras = miv_cameras(*field.cameras, {40, 30}, {"view_000", "view_001"}, 0.5, 2.0);
  cameras[1].focal_px.x = 990.0;
  std::ofstream(dir / "m/cameras.json") << miv_cameras_text(cameras, "room", true);
  const LightField back = miv_format().read(dir / "m", {});
  EXPECT_FALSE(back.cameras);
  ASSERT_TRUE(back.poses && back.depth);
  EXPECT_EQ((*back.poses)[1].focal_px, Vec2d(990.0, 1000.0));
  EXPECT_LT(glm::distance((*back.poses)[1].position_mm, Vec3d(10.0, 6.0, 0.0)), 1e-9);
  EXPECT_EQ((*back.poses)[1].principal_px, Vec2d(40.0, 3.0));
  EXPECT_FLOAT_EQ(back.depth->data[0], -500.0f) << "z in the camera's frame: the largest code is `near`, 0.5 m";
  const auto reason = [&] { return unknown_cameras(miv_format().read(dir / "m", {})); };
  EXPECT_THAT(reason(), HasSubstr("the camera of view 1 has the focal lengths 990x1000 pixels, and that of view 0 has "
                                  "1000x1000"));
  cameras[1].focal_px.x = 1000.0, cameras[1].rotation_deg[1] = 3.0;
  std::ofstream(dir / "m/cameras.json") << miv_cameras_text(cameras, "room", true);
  EXPECT_THAT(reason(), HasSubstr("the camera of view 1 is rotated against that of view 0"));
  cameras[1].rotation_deg[1] = 0.0, cameras[1].position_m[0] = 0.1;
  std::ofstream(dir / "m/cameras.json") << miv_cameras_text(cameras, "room", true);
  EXPECT_THAT(reason(), HasSubstr("the camera of view 1 is not in one plane with that of view 0"));
}

TEST(MivFormat, depth_codes_match_formula) {
  const TempDir dir;
  LightField field = two_views();
  field.depth = Image(40, 60, 1);
  for (std::size_t i = 0; i < field.depth->data.size(); ++i) field.depth->data[i] = i % 2 == 0 ? 250.0f : -500.0f;
  field.depth->data[3] = -INFINITY;
  const LightFieldFormat miv = miv_format();
  miv.write(field, dir / "m", {});
  const LightField back = miv.read(dir / "m", {});
  EXPECT_TRUE(same_samples(back.stack, field.stack));
  EXPECT_EQ(back.grid, field.grid);
  const Image16 codes = std::get<Image16>(read_picture(dir / "m/view_000_depth.png"));
  EXPECT_EQ(codes.rgb[0], 65535) << "the nearest";
  EXPECT_EQ(codes.rgb[3], 64) << "the farthest: 1 of 1023 codes in 10 bits, where 0 is nothing";
  EXPECT_EQ(codes.rgb[9], 0);
  // The tolerance is half a 16-bit code. Codes are linear in 1 / distance, from 1/m to 4/m, so at 1 m half a code is (4 - 1) /
  // 65535 / 2 m = 0.023 mm.
  for (const std::size_t i : {0u, 1u, 2u, 1201u}) EXPECT_NEAR(back.depth->data[i], field.depth->data[i], 0.024f) << i;
  EXPECT_EQ(back.depth->data[3], -INFINITY);
}

TEST(MivFormat, walls_of_one_depth_come_back) {
  const TempDir dir;
  LightField field = two_views();
  field.depth = Image(40, 60, 1);
  for (float& z : field.depth->data) z = -500.0f;
  miv_format().write(field, dir / "m", {});
  EXPECT_NEAR(miv_format().read(dir / "m", {}).depth->data[0], -500.0f, 1e-3f);
}

TEST(MivFormat, rejects_missing_cameras_and_pictures) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] {
                miv_format().write(numbered_field({2, 1}, {4, 3}), dir / "m", {});
              }),
              HasSubstr("cameras of these views are unknown"));
  miv_format().write(two_views(), dir / "n", {});
  std::filesystem::remove(dir / "n/view_001.png");
  EXPECT_THAT(error_message([&] { miv_format().read(dir / "n", {}); }), HasSubstr("view_001 is missing"));
  EXPECT_THAT(error_message([&] { miv_format().read(dir / "none", {}); }), HasSubstr("cameras.json"));
}

TEST(MivCameras, files_that_make_no_cameras_are_refused) {
  const std::string good = miv_cameras_text(cameras_by_hand(), "room", true);
  const auto refusal = [&](const std::string& part, const std::string& other) {
    std::string text = good;
    text.replace(text.find(part), part.size(), other);
    return error_message([&] { parse_miv_cameras(text, "c.json"); });
  };
  EXPECT_THAT(error_message([] { parse_miv_cameras("{", "c.json"); }), AllOf(HasSubstr("c.json"), HasSubstr("not JSON")));
  EXPECT_THAT(refusal("\"Focal\": [", "\"Focal\": [NaN, "),
              AllOf(HasSubstr("c.json:"), HasSubstr("cameras[0].Focal[0]: 'NaN' is not JSON"), HasSubstr("finite numbers")));
  EXPECT_THAT(refusal("\"Position\": [", "\"Position\": [-1e400, "), HasSubstr("cameras[0].Position[0]: '-1e400'"));
  EXPECT_THAT(error_message([&] { parse_miv_cameras(good.substr(0, good.rfind("Focal") + 10), "c.json"); }),
              AllOf(HasSubstr("cameras[1].Focal"), HasSubstr("ends too early")));
  EXPECT_THAT(error_message([] { parse_miv_cameras(R"({"cameras": []})", "c"); }), HasSubstr("0 cameras"));
  EXPECT_THAT(error_message([] { parse_miv_cameras(R"({"cameras": [1]})", "c"); }), HasSubstr("is not an object"));
  EXPECT_THAT(refusal("\"Name\": \"a\"", "\"Name\": \"../a\""), HasSubstr("Name"));
  EXPECT_THAT(refusal("\"Name\": \"b\"", "\"Name\": \"a\""), HasSubstr("c.json: cameras[1].Name: repeats 'a'"));
  EXPECT_THAT(refusal("Perspective", "Equirectangular"), HasSubstr("Projection"));
  EXPECT_THAT(refusal("\"Focal\"", "\"Fokal\""), HasSubstr("c.json: cameras[0].Focal: is missing"));
  EXPECT_THAT(refusal("\"Position\": [", "\"Position\": [1e300, "), HasSubstr("Position"));
}

}  // namespace
}  // namespace lippmann

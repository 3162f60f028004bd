#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/npy.hpp"
#include "core/regular_file.hpp"
#include "formats/colmap_model.hpp"
#include "formats/llff_poses.hpp"
#include "formats/transforms_json.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/subset.hpp"
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

/// Returns views of 3 x 2 eyes 20 mm apart. The eyes are 500 mm in front of a plane in which pixels are 0.5 mm wide,
/// and a wall is 250 mm behind that plane.
LightField six_views() {
  LightField field = numbered_field({3, 2}, {40, 30});
  field.cameras = {500.0, Vec2d(0.5), Vec2d(20.0, 15.0), {}};
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column) field.cameras->eyes_mm.emplace_back(20.0 * column - 20.0, 20.0 * row - 10.0);
  field.depth = Image(40, 30 * 6, 1);
  for (float& z : field.depth->data) z = -250.0f;
  field.depth->data[7] = -INFINITY;
  return field;
}

/// Returns views of cameras that look at the origin from 2 m. From camera to camera, the position rotates by 40 degrees
/// about the vertical and rises by 10 degrees.
LightField turned_views(int count = 4) {
  LightField field = numbered_field({count, 1}, {40, 30});
  field.poses.emplace();
  for (int view = 0; view < count; ++view) {
    const glm::dquat turn = glm::angleAxis(glm::radians(40.0 * view), Vec3d(0.0, 1.0, 0.0)) *
                            glm::angleAxis(glm::radians(-10.0 * view), Vec3d(1.0, 0.0, 0.0));
    const glm::dmat3 rotation = glm::mat3_cast(turn);
    field.poses->push_back({{40, 30}, Vec2d(50.0), Vec2d(20.0, 15.0), rotation, 2000.0 * rotation[2]});
  }
  field.depth = Image(40, 30 * count, 1);
  for (float& z : field.depth->data) z = -2000.0f;
  return field;
}

void expect_same_poses(const std::vector<PosedCamera>& a, const std::vector<PosedCamera>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t view = 0; view < a.size(); ++view) {
    EXPECT_LT(glm::distance(a[view].position_mm, b[view].position_mm), 1e-3) << view << ": 1e-6 m";
    for (int axis = 0; axis < 3; ++axis) EXPECT_LT(glm::distance(a[view].rotation[axis], b[view].rotation[axis]), 1e-6) << view;
    EXPECT_LT(glm::distance(a[view].focal_px, b[view].focal_px), 1e-6) << view;
    EXPECT_LT(glm::distance(a[view].principal_px, b[view].principal_px), 1e-6) << view;
  }
}

TEST(PosedCameras, principal_point_moves_with_the_eye) {
  const PosedCamera right = posed_cameras(six_views(), "a")[2];
  EXPECT_EQ(right.focal_px, Vec2d(1000.0)) << "500 mm / 0.5 mm";
  EXPECT_EQ(right.principal_px, Vec2d(20.0 + 40.0, 15.0 + 20.0)) << "20 mm right and 10 mm down are 40 and 20 pixels";
  EXPECT_EQ(right.position_mm, Vec3d(20.0, -10.0, 500.0));
}

TEST(PosedCameras, known_point_lands_on_known_pixel) {
  // The point (10, 5, 200) mm is 300 mm from the plane of the eyes. From the eye at (20, -10), it is 10 mm to the left
  // and 15 mm up. At 300 mm, 1 mm is 1000 / 300 pixels.
  const PosedCamera right = posed_cameras(six_views(), "a")[2];
  const Vec2d pixel = projected(right, {10.0, 5.0, 200.0});
  EXPECT_NEAR(pixel.x, 60.0 - 10.0 * 1000.0 / 300.0, 1e-9);
  EXPECT_NEAR(pixel.y, 35.0 - 15.0 * 1000.0 / 300.0, 1e-9);
  EXPECT_LT(glm::distance(unprojected(right, pixel, 300.0), Vec3d(10.0, 5.0, 200.0)), 1e-9);
}

TEST(PosedFormats, grids_keep_cameras_and_depth) {
  for (const char* name : {"nerf", "colmap"}) {
    const TempDir dir;
    const LightField field = six_views();
    const LightFieldFormat& format = find_format(name, "format");
    format.write(field, dir / "m", {});
    const LightField back = format.read(dir / "m", {});
    EXPECT_TRUE(same_samples(back.stack, field.stack)) << name;
    EXPECT_EQ(back.grid, field.grid) << name;
    ASSERT_TRUE(back.cameras) << name;
    expect_same_poses(posed_cameras(back, "a"), posed_cameras(field, "a"));
  }
}

TEST(PosedFormats, turned_cameras_keep_poses) {
  for (const char* name : {"nerf", "colmap", "llff"}) {
    const TempDir dir;
    const LightField field = turned_views();
    const LightFieldFormat& format = find_format(name, "format");
    format.write(field, dir / "m", {});
    const LightField back = format.read(dir / "m", {});
    EXPECT_FALSE(back.cameras) << name;
    ASSERT_TRUE(back.poses) << name;
    expect_same_poses(*back.poses, *field.poses);
    EXPECT_TRUE(same_samples(back.stack, field.stack)) << name;
  }
}

TEST(PosedFormats, subsets_keep_their_cameras) {
  LightField field = turned_views();
  keep(field, {{1, 3, 2}, {}}, "keep");
  crop(field, {{20, 10}, {4, 6}}, "crop");
  ASSERT_EQ(field.poses->size(), 2u);
  EXPECT_EQ((*field.poses)[1].position_mm, (*turned_views().poses)[3].position_mm);
  EXPECT_EQ((*field.poses)[1].size, field.view_size);
  EXPECT_EQ((*field.poses)[1].principal_px, Vec2d(20.0 - 4.0, 15.0 - 6.0));
}

TEST(NerfFormat, walls_have_constant_z) {
  const TempDir dir;
  const LightField field = six_views();
  nerf_format().write(field, dir / "m", {});
  const auto array = [&](const char* name) { return parse_npy(read_file_bytes(dir / "m" / name, 1 << 20), name); };
  const NpyArray z = array("depth/000.npy"), rays = array("depth/000_ray.npy");
  EXPECT_EQ(z.shape, (std::vector<std::size_t>{30, 40}));
  const PosedCamera camera = posed_cameras(field, "a")[0];
  for (std::size_t i = 0; i < z.values.size(); ++i) {
    if (i == 7) continue;
    EXPECT_NEAR(z.values[i], 750.0, 750.0 * 1e-5);
    const Vec2d off = (Vec2d(i % 40 + 0.5, i / 40 + 0.5) - camera.principal_px) / camera.focal_px;
    EXPECT_NEAR(rays.values[i], 750.0 / std::cos(std::atan(glm::length(off))), 750.0 * 1e-6);
  }
  EXPECT_EQ(z.values[7], 0.0) << "nothing is there";
  EXPECT_EQ(rays.values[7], 0.0);
  const LightField back = nerf_format().read(dir / "m", {});
  ASSERT_TRUE(back.depth);
  EXPECT_NEAR(back.depth->data[0], -250.0f, 1e-3f);
  EXPECT_EQ(back.depth->data[7], -INFINITY);
}

TEST(NerfFormat, ray_at_30_degrees_is_longer) {
  // The ray is 30 degrees off the axis. With a focal length of 100 pixels, it meets 100 tan(30 degrees) pixels from the
  // principal point. Its length is 1000 mm / cos(30 degrees).
  const PosedCamera camera{{1, 1}, Vec2d(100.0), Vec2d(0.5 - 100.0 * std::tan(std::numbers::pi / 6.0), 0.5), {}, {}};
  Image depth(1, 1, 1);
  depth.data[0] = 1000.0f;
  EXPECT_NEAR(ray_lengths(depth, camera).data[0], 1154.7f, 0.01f);
}

TEST(NerfFormat, matrices_have_axes_of_blender) {
  const TempDir dir;
  nerf_format().write(turned_views(2), dir / "m", {});
  const auto json = nlohmann::json::parse(read_file_text(dir / "m/transforms.json", 1 << 20));
  EXPECT_NEAR(json["fl_x"].get<double>(), 50.0, 1e-12);
  EXPECT_NEAR(json["camera_angle_x"].get<double>(), 2.0 * std::atan(20.0 / 50.0), 1e-12);
  const auto& matrix = json["frames"][0]["transform_matrix"];
  EXPECT_EQ(matrix[2], (nlohmann::json{0.0, 0.0, 1.0, 2.0})) << "not turned, 2 m towards the viewer";
  EXPECT_THAT(json["depth"]["depth_file_path"].get<std::string>(), HasSubstr("planar depth (z)"));
}

TEST(NerfFormat, blenders_files_without_endings_are_read) {
  const TempDir dir;
  nerf_format().write(turned_views(2), dir / "m", {});
  std::ofstream(dir / "m/transforms.json")
      << R"({"camera_angle_x": 0.9273, "frames": [{"file_path": "./images/001", "transform_matrix":
             [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3], [0, 0, 0, 1]]}]})";
  const LightField field = nerf_format().read(dir / "m", {});
  EXPECT_NEAR(field.poses->front().focal_px.x, 20.0 / std::tan(0.9273 / 2.0), 1e-9);
  EXPECT_EQ(field.poses->front().principal_px, Vec2d(20.0, 15.0));
  EXPECT_EQ(field.poses->front().position_mm, Vec3d(0.0, 0.0, 3000.0));
  EXPECT_TRUE(same_samples(field.stack, view_of(turned_views(2), 1)));
}

TEST(NerfFormat, repeated_pictures_are_refused) {
  const TempDir dir;
  nerf_format().write(turned_views(2), dir / "m", {});
  std::ifstream file(dir / "m/transforms.json");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string second = "images/001.png";
  for (std::size_t at = 0; (at = text.find(second)) != std::string::npos;) text.replace(at, second.size(), "images/000.png");
  std::ofstream(dir / "m/transforms.json") << text;
  EXPECT_THAT(error_message([&] { nerf_format().read(dir / "m", {}); }),
              AllOf(HasSubstr("frames[1]"), HasSubstr("repeats the picture 'images/000.png'")));
}

TEST(NerfFormat, wrong_cameras_are_refused_with_their_frame) {
  const std::string good =
      transforms_text({{"", "a.png", "", turned_views().poses->at(0)}, {"", "b.png", "", turned_views().poses->at(1)}});
  parse_transforms(good, "t.json");
  const auto refusal = [&](const std::string& part, const std::string& other) {
    std::string text = good;
    EXPECT_NE(text.find(part), std::string::npos) << part;
    text.replace(text.rfind(part), part.size(), other);
    return error_message([&] { parse_transforms(text, "t.json"); });
  };
  EXPECT_THAT(error_message([] { parse_transforms("[", "t.json"); }), AllOf(HasSubstr("t.json"), HasSubstr("not JSON")));
  EXPECT_THAT(error_message([] { parse_transforms("[]", "t.json"); }), HasSubstr("not a JSON object"));
  EXPECT_THAT(error_message([] { parse_transforms(R"({"frames": []})", "t.json"); }), HasSubstr("0 frames"));
  EXPECT_THAT(refusal("transform_matrix", "matrix"), AllOf(HasSubstr("frames[1]"), HasSubstr("missing")));
  EXPECT_THAT(refusal("\"b.png\"", "\"../b.png\""), AllOf(HasSubstr("frames[1]"), HasSubstr("inside the folder")));
  EXPECT_THAT(refusal("\"fl_x\": 50.0", "\"fl_x\": -50.0"), HasSubstr("fl_x"));
  EXPECT_THAT(refusal("\"fl_x\": 50.0", "\"fl_x\": NaN"), AllOf(HasSubstr("t.json: fl_x"), HasSubstr("'NaN'")));
  EXPECT_THAT(error_message([] { parse_transforms(R"({"fl_y": 50, "frames": [{"file_path": "a"}]})", "t.json"); }),
              AllOf(HasSubstr("frames[0]"), HasSubstr("fl_x: is missing")));
  EXPECT_THAT(refusal("\"fl_x\": 50.0", "\"k1\": 0.1, \"fl_x\": 50.0"), AllOf(HasSubstr("k1"), HasSubstr("distortion")));
  const auto matrix = [](const char* rows) {
    return error_message([&] {
      parse_transforms(R"({"fl_x": 50, "frames": [{"file_path": "a", "transform_matrix": )" + std::string(rows) + "}]}",
                       "t.json");
    });
  };
  EXPECT_THAT(matrix("[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"), AllOf(HasSubstr("frames[0]"), HasSubstr("left-handed")));
  EXPECT_THAT(matrix("[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"), HasSubstr("not a rotation"));
  EXPECT_THAT(matrix("[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,2]]"), HasSubstr("last row"));
  EXPECT_THAT(matrix("[[1,0,0],[0,1,0],[0,0,1]]"), HasSubstr("transform_matrix"));
  for (const char* number : {"NaN", "1e400", "-Infinity"})
    EXPECT_THAT(matrix(("[[1,0,0,0],[0,1,0," + std::string(number) + "]]").c_str()),
                AllOf(HasSubstr("t.json: frames[0].transform_matrix[1][3]"), HasSubstr(number)));
}

TEST(NerfFormat, frames_inherit_what_they_do_not_state) {
  const auto pictures = parse_transforms(R"({"w": 40, "h": 30, "fl_x": 50, "fl_y": 51, "cx": 20, "cy": 15, "frames": [
      {"file_path": "a", "fl_y": 52, "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0]]},
      {"file_path": "b", "fl_x": 53, "cx": 21, "h": 31, "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0]]}]})",
                                         "t.json");
  EXPECT_EQ(pictures[0].camera.focal_px, Vec2d(50.0, 52.0));
  EXPECT_EQ(pictures[0].camera.size, Vec2i(40, 30));
  EXPECT_EQ(pictures[1].camera.focal_px, Vec2d(53.0, 51.0));
  EXPECT_EQ(pictures[1].camera.principal_px, Vec2d(21.0, 15.0));
  EXPECT_EQ(pictures[1].camera.size, Vec2i(40, 31));
}

/// Returns four turned views, the second for validation and the last for testing.
LightField split_views() {
  LightField field = turned_views();
  field.splits = {Split::kTraining, Split::kValidation, Split::kTraining, Split::kTest};
  return field;
}

TEST(NerfFormat, splits_come_back) {
  const TempDir dir;
  const LightField field = split_views();
  nerf_format().write(field, dir / "m", {});
  EXPECT_EQ(nerf_format().read(dir / "m", {}).splits, field.splits);
  const auto json = nlohmann::json::parse(read_file_text(dir / "m/transforms_test.json", 1 << 20));
  EXPECT_EQ(json["frames"].size(), 1u);
  EXPECT_EQ(json["frames"][0]["file_path"], "./images/003");
}

TEST(NerfFormat, undefined_depth_is_named_once) {
  const TempDir dir;
  nerf_format().write(turned_views(), dir / "m", {});
  for (const int view : {1, 3}) {
    Image depth(40, 30, 1);
    std::ranges::fill(depth.data, 2000.0f);
    depth.data[0] = 0.0f, depth.data[2 * 40 + 5] = std::nanf(""), depth.data[100] = std::nanf("");
    const std::vector<std::size_t> shape{30, 40};
    const std::vector<std::byte> bytes = encode_npy(std::span<const float>(depth.data), shape);
    std::ofstream(dir / fmt::format("m/depth/{:03}.npy", view), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  }
  std::vector<std::string> warnings;
  FormatOptions options;
  options.warn = [&](std::string_view warning) { warnings.emplace_back(warning); };
  const LightField field = nerf_format().read(dir / "m", options);
  ASSERT_THAT(warnings, testing::SizeIs(1));
  EXPECT_THAT(warnings[0], AllOf(HasSubstr("depth/001.npy: pixel (5, 2)"), HasSubstr("4 in all views")));
  EXPECT_EQ(*depth_of(field, 1).pixel(5, 2), -INFINITY);
  EXPECT_EQ(*depth_of(field, 1).pixel(6, 2), -2000.0f);
}

TEST(NerfFormat, files_of_parts_name_pictures_without_extension) {
  const TempDir dir;
  nerf_format().write(split_views(), dir / "m", {});
  for (const auto& [name, pictures] : {std::pair("train", 2), std::pair("val", 1), std::pair("test", 1)}) {
    const std::string file = std::string("m/transforms_") + name + ".json";
    const auto json = nlohmann::json::parse(read_file_text(dir / file, 1 << 20));
    EXPECT_EQ(std::ssize(json["frames"]), pictures) << name;
    EXPECT_TRUE(json.contains("camera_angle_x")) << name;
    for (const auto& frame : json["frames"])
      EXPECT_TRUE(std::filesystem::exists(dir / "m" / (frame["file_path"].get<std::string>() + ".png"))) << frame;
  }
  const auto all = nlohmann::json::parse(read_file_text(dir / "m/transforms.json", 1 << 20));
  EXPECT_EQ(all["frames"][3]["file_path"], "images/003.png");
  EXPECT_EQ(all["val_filenames"], nlohmann::json({"images/001.png"}));
}

TEST(NerfFormat, files_of_parts_are_read_together) {
  const TempDir dir;
  nerf_format().write(split_views(), dir / "m", {});
  std::filesystem::remove(dir / "m/transforms.json");
  const LightField field = nerf_format().read(dir / "m", {});
  EXPECT_EQ(field.splits, (std::vector{Split::kTraining, Split::kTraining, Split::kValidation, Split::kTest}));
  EXPECT_EQ((*field.poses)[2].position_mm, (*turned_views().poses)[1].position_mm);
}

TEST(PosedFormats, held_out_views_are_listed_for_colmap_and_llff) {
  for (const char* name : {"colmap", "llff"}) {
    const TempDir dir;
    find_format(name, "format").write(split_views(), dir / "m", {});
    const char* list = name == std::string("llff") ? "m/test.txt" : "m/sparse/0/test.txt";
    EXPECT_EQ(read_file_text(dir / list, 1 << 20), "001.png\n003.png\n") << name;
    const auto splits = find_format(name, "format").read(dir / "m", {}).splits;
    EXPECT_EQ(splits, (std::vector{Split::kTraining, Split::kTest, Split::kTraining, Split::kTest})) << name;
  }
}

TEST(PosedFormats, subsets_keep_splits_and_bounds) {
  LightField field = split_views();
  field.depth_bounds_mm = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
  keep(field, {{1, 3, 2}, {}}, "keep");
  EXPECT_EQ(field.splits, (std::vector{Split::kValidation, Split::kTest}));
  EXPECT_EQ(field.depth_bounds_mm, (std::vector<Vec2d>{{3, 4}, {7, 8}}));
}

TEST(NerfFormat, depth_of_16_bits_is_in_thousandths) {
  const TempDir dir;
  const LightField field = turned_views(1);
  nerf_format().write(field, dir / "m", {});
  Image16 codes{40, 30, std::vector<std::uint16_t>(std::size_t{3} * 40 * 30, 1234)};
  std::fill_n(codes.rgb.begin(), 3, std::uint16_t{0});
  const auto replace_depth = [&](const char* name) {
    std::string text = read_file_text(dir / "m/transforms.json", 1 << 20);
    text.replace(text.find("depth/000.npy"), 13, name);
    std::ofstream(dir / "m/transforms.json") << text;
  };
  replace_depth("depth/000.png");
  write_picture(dir / "m/depth/000.png", codes);
  const LightField back = nerf_format().read(dir / "m", {});
  ASSERT_TRUE(back.depth);
  EXPECT_EQ(back.depth->data[0], -INFINITY) << "0 means no surface";
  EXPECT_EQ(back.depth->data[1], -1234.0f) << "nerfstudio's default unit is 0.001";
  write_picture(dir / "m/depth/000.png", Image8{40, 30, std::vector<unsigned char>(std::size_t{3} * 40 * 30, 9)});
  EXPECT_THAT(error_message([&] { nerf_format().read(dir / "m", {}); }), AllOf(HasSubstr("000.png"), HasSubstr("16 bits")));
}

TEST(NerfFormat, depth_that_is_not_read_is_named) {
  const TempDir dir;
  nerf_format().write(turned_views(2), dir / "m", {});
  std::filesystem::remove(dir / "m/depth/001.npy");
  std::string warning;
  const LightField field = nerf_format().read(dir / "m", {.warn = [&](std::string_view text) { warning += text; }});
  EXPECT_FALSE(field.depth);
  EXPECT_THAT(warning, AllOf(HasSubstr("frames[1]"), HasSubstr("depth/001.npy"), HasSubstr("missing")));
}

TEST(NerfFormat, huge_files_are_refused) {
  const TempDir dir;
  std::ofstream(dir / "transforms.json") << "{";
  std::filesystem::resize_file(dir / "transforms.json", std::uintmax_t{2} << 30);  // a sparse file
  EXPECT_THAT(error_message([&] { nerf_format().read(dir.path(), {}); }), HasSubstr("transforms.json"));
}

TEST(PosedFormats, pictures_of_other_sizes_are_refused) {
  for (const char* name : {"nerf", "colmap", "llff"}) {
    const TempDir dir;
    const LightFieldFormat& format = find_format(name, "format");
    format.write(turned_views(2), dir / "m", {});
    for (const char* picture : {"m/images/000.png", "m/images/001.png"})
      write_picture(dir / picture, numbered_field({1, 1}, {20, 15}).stack);
    EXPECT_THAT(error_message([&] { format.read(dir / "m", {}); }),
                AllOf(HasSubstr("40x30"), HasSubstr("20x15"), HasSubstr("000.png")))
        << name;
  }
}

TEST(NerfFormat, cameras_that_disagree_with_pictures_are_refused) {
  const TempDir dir;
  nerf_format().write(turned_views(2), dir / "m", {});
  std::string text = read_file_text(dir / "m/transforms.json", 1 << 20);
  text.replace(text.find("\"w\": 40"), 7, "\"w\": 41");
  std::ofstream(dir / "m/transforms.json") << text;
  EXPECT_THAT(error_message([&] { nerf_format().read(dir / "m", {}); }),
              AllOf(HasSubstr("frames[0]"), HasSubstr("41x30"), HasSubstr("40x30")));
  nerf_format().write(turned_views(2), dir / "n", {});
  std::filesystem::remove(dir / "n/images/001.png");
  EXPECT_THAT(error_message([&] { nerf_format().read(dir / "n", {}); }), AllOf(HasSubstr("frames[1]"), HasSubstr("missing")));
  EXPECT_THAT(error_message([&] {
                nerf_format().write(numbered_field({1, 1}, {4, 4}), dir / "o", {});
              }),
              HasSubstr("cameras of these views are unknown"));
}

TEST(ColmapFormat, poses_are_camera_from_world) {
  // Cameras look along -z in this library and along +z in COLMAP, which rotates them by 180 degrees about x. The camera
  // at z = 2 m has the origin 2 m in front of it.
  const PosedPicture picture{"", "000.png", "", turned_views().poses->at(0)};
  const std::string text = colmap_images_text({picture});
  EXPECT_THAT(text, HasSubstr("\n1 0 1 0 0 0 0 2 1 000.png\n\n"));
  EXPECT_THAT(colmap_cameras_text({picture}), HasSubstr("\n1 PINHOLE 40 30 50 50 20 15\n"));
}

TEST(ColmapFormat, clouds_lie_where_depth_is) {
  const LightField field = six_views();
  const std::vector<CloudPoint> all = point_cloud(field, posed_cameras(field, "a"), 100000);
  EXPECT_EQ(all.size(), 40u * 30u * 6u - 1u) << "but for the pixel where nothing is";
  for (const CloudPoint& point : all) EXPECT_NEAR(point.position_mm.z, -250.0, 1e-3);
  const auto& codes = std::get<Image8>(field.stack).rgb;
  EXPECT_EQ(all[0].rgb[1], codes[1]);
  EXPECT_LE(point_cloud(field, posed_cameras(field, "a"), 100).size(), 100u);
}

/// Returns parallel views of a grid with two points: one is 250 mm behind the display plane, the other 100 mm in front
/// of it.
LightField views_with_points() {
  LightField field = six_views();
  field.depth.reset();
  field.points = {{{10.0, 5.0, -250.0}, {1, 2, 3}}, {{-30.0, 0.25, 100.0}, {255, 0, 128}}};
  return field;
}

TEST(ColmapFormat, points_come_back_as_text_and_binary) {
  for (const bool binary : {false, true})
    for (const bool turned : {false, true}) {
      const TempDir dir;
      LightField field = views_with_points();
      if (turned) {
        field = turned_views();
        field.depth.reset(), field.points = views_with_points().points;
      }
      colmap_format().write(field, dir / "m", {.binary = binary});
      EXPECT_EQ(std::filesystem::exists(dir / "m/sparse/0/points3D.bin"), binary);
      EXPECT_NE(std::filesystem::exists(dir / "m/sparse/0/cameras.txt"), binary);
      std::string warning;
      const LightField back = colmap_format().read(dir / "m", {.warn = [&](std::string_view text) { warning += text; }});
      EXPECT_EQ(warning, "");
      expect_same_poses(posed_cameras(back, "a"), posed_cameras(field, "a"));
      ASSERT_EQ(back.points.size(), 2u);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(glm::distance(back.points[i].position_mm, field.points[i].position_mm), 1e-5) << i;
        EXPECT_EQ(back.points[i].rgb, field.points[i].rgb) << i;
      }
    }
}

TEST(ColmapFormat, points_keep_their_pixels_in_grids) {
  // Two cameras 20 mm apart and a point, all turned by 90 degrees about z. Both cameras see the same window at a
  // distance of 500 mm, so they are read as a grid. The grid has its own coordinates.
  const TempDir dir;
  LightField field = numbered_field({2, 1}, {40, 30});
  const glm::dmat3 turn(Vec3d(0.0, 1.0, 0.0), Vec3d(-1.0, 0.0, 0.0), Vec3d(0.0, 0.0, 1.0));
  for (const double x : {0.0, 20.0}) {
    if (!field.poses) field.poses.emplace();
    field.poses->push_back({{40, 30}, Vec2d(1000.0), Vec2d(20.0 + 2.0 * x, 15.0), turn, turn * Vec3d(x, 0.0, 7.0)});
  }
  field.points = {{turn * Vec3d(3.0, 2.0, -400.0), {}}};
  colmap_format().write(field, dir / "m", {});
  const LightField back = colmap_format().read(dir / "m", {});
  ASSERT_TRUE(back.cameras);
  for (const std::size_t view : {0u, 1u})
    EXPECT_LT(glm::distance(projected(posed_cameras(back, "a")[view], back.points[0].position_mm),
                            projected((*field.poses)[view], field.points[0].position_mm)),
              1e-6);
}

TEST(ColmapFormat, tracks_are_named_as_left_out) {
  const TempDir dir;
  colmap_format().write(turned_views(2), dir / "m", {});
  std::ofstream(dir / "m/sparse/0/points3D.txt") << "# comment\n7 0.5 -0.25 2 9 8 7 0.3 1 0 2 5\n8 1 1 1 0 0 0 -1\n";
  std::string warning;
  const LightField field = colmap_format().read(dir / "m", {.warn = [&](std::string_view text) { warning += text; }});
  ASSERT_EQ(field.points.size(), 2u);
  EXPECT_EQ(field.points[0].position_mm, Vec3d(500.0, -250.0, 2000.0));
  EXPECT_EQ(field.points[0].rgb[0], 9);
  EXPECT_THAT(warning, AllOf(HasSubstr("points3D.txt"), HasSubstr("the tracks of 1 points are left out")));
}

TEST(ColmapFormat, wrong_points_are_refused) {
  const auto points = [](const char* text) { return error_message([&] { parse_colmap_points(text, "p.txt"); }); };
  EXPECT_THAT(points("\n1 0 0 nan 1 2 3 0\n"), AllOf(HasSubstr("p.txt:2"), HasSubstr("'nan'")));
  EXPECT_THAT(points("1 0 0 0 1 2 256 0\n"), HasSubstr("colour"));
  const std::string binary = colmap_points_binary({{}, {}});
  EXPECT_EQ(binary.size(), 8u + 2u * 51u) << "a number of 8 bytes; per point 8 + 24 + 3 + 8 + 8 bytes";
  EXPECT_THAT(error_message([&] { parse_colmap_points(std::as_bytes(std::span(binary)).first(binary.size() - 1), "p.bin"); }),
              AllOf(HasSubstr("p.bin: point 2"), HasSubstr("truncated")));
}

template <class T>
void put(std::vector<std::byte>& bytes, T value) {
  const auto raw = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

TEST(ColmapFormat, binary_models_say_the_same_as_text) {
  std::vector<std::byte> cameras, images;
  put<std::uint64_t>(cameras, 1), put<std::uint32_t>(cameras, 7), put<std::uint32_t>(cameras, 1);
  put<std::uint64_t>(cameras, 40), put<std::uint64_t>(cameras, 30);
  for (const double param : {50.0, 51.0, 20.0, 15.0}) put(cameras, param);
  put<std::uint64_t>(images, 1), put<std::uint32_t>(images, 3);
  for (const double value : {0.0, 1.0, 0.0, 0.0, 0.5, -0.25, 2.0}) put(images, value);
  put<std::uint32_t>(images, 7);
  for (const char c : {'a', '.', 'p', 'n', 'g', '\0'}) put(images, c);
  put<std::uint64_t>(images, 1), put(images, 1.0), put(images, 2.0), put<std::int64_t>(images, -1);
  const auto binary = parse_colmap_images(images, parse_colmap_cameras(cameras, "c"), "i");
  const ColmapCameras same = parse_colmap_cameras("# comment\n7 PINHOLE 40 30 50 51 20 15\n", "c");
  const auto text = parse_colmap_images("3 0 1 0 0 0.5 -0.25 2 7 a.png\n1 2 -1\n", same, "i");
  ASSERT_EQ(binary.size(), 1u);
  ASSERT_EQ(text.size(), 1u);
  EXPECT_EQ(binary[0].picture, "a.png");
  expect_same_poses({binary[0].camera}, {text[0].camera});
  EXPECT_EQ(binary[0].camera.focal_px, Vec2d(50.0, 51.0));
  EXPECT_LT(glm::distance(binary[0].camera.position_mm, Vec3d(-500.0, -250.0, 2000.0)), 1e-9);
  images.resize(images.size() - 1);
  EXPECT_THAT(error_message([&] { parse_colmap_images(images, same, "i.bin"); }),
              AllOf(HasSubstr("i.bin: image 1"), HasSubstr("truncated")));
}

TEST(ColmapFormat, wrong_lines_are_refused_with_their_number) {
  const auto cameras = [](const char* text) { return error_message([&] { parse_colmap_cameras(text, "c.txt"); }); };
  EXPECT_THAT(cameras("#\n1 PINHOLE 40 30 50 nan 20 15"), AllOf(HasSubstr("c.txt:2"), HasSubstr("'nan'")));
  EXPECT_THAT(cameras("1 OPENCV 40 30 50 50 20 15 0.1 0 0 0"), HasSubstr("has distortion"));
  EXPECT_THAT(cameras("1 OPENCV_FISHEYE 40 30 50 50 20 15 0 0 0 0"), HasSubstr("OPENCV_FISHEYE"));
  EXPECT_THAT(cameras("1 PINHOLE 40 30 50 50 20"), HasSubstr("ends before"));
  EXPECT_THAT(cameras("1 PINHOLE 4 3 5 5 2 1\n1 PINHOLE 4 3 5 5 2 1"), HasSubstr("repeats the number 1"));
  const ColmapCameras known = parse_colmap_cameras("1 PINHOLE 4 3 5 5 2 1", "c");
  const auto images = [&](const char* text) { return error_message([&] { parse_colmap_images(text, known, "i.txt"); }); };
  EXPECT_THAT(images("1 1 0 0 0 0 0 0 2 a.png\n"), AllOf(HasSubstr("i.txt:1"), HasSubstr("camera 2 is missing")));
  EXPECT_THAT(images("1 9 0 0 0 0 0 0 1 a.png\n"), HasSubstr("unit quaternion"));
  EXPECT_THAT(images("1 1 0 0 0 0 0 0 1 /a.png\n"), HasSubstr("inside the folder"));
}

TEST(LlffFormat, rows_have_axes_down_right_back) {
  const PosedCamera camera = turned_views().poses->at(0);
  const NpyArray rows = parse_npy(encode_llff_poses({camera}, {{1500.0, 2500.0}}, "a"), "a");
  EXPECT_EQ(rows.shape, (std::vector<std::size_t>{1, 17}));
  EXPECT_EQ(rows.values, (std::vector<double>{0, 1, 0, 0, 30, -1, 0, 0, 0, 40, 0, 0, 1, 2, 50, 1.5, 2.5}));
}

TEST(LlffFormat, points_give_the_depth_bounds) {
  const TempDir dir;
  LightField field = turned_views(2);
  field.depth.reset();
  const Vec3d eye = field.poses->at(0).position_mm;  // 2 m from the origin
  field.points = {{Vec3d(0.0), {}}, {0.75 * eye, {}}, {1.5 * eye, {}}};
  llff_format().write(field, dir / "m", {});
  const Vec2d bounds = llff_format().read(dir / "m", {}).depth_bounds_mm->at(0);
  EXPECT_NEAR(bounds.x, 500.0, 1e-6);
  EXPECT_NEAR(bounds.y, 2000.0, 1e-6) << "the third point is behind the camera";
}

TEST(LlffFormat, unknown_depth_gives_a_warning) {
  const TempDir dir;
  LightField field = turned_views(2);
  field.depth.reset();
  std::vector<std::string> warnings;
  FormatOptions options;
  options.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  llff_format().write(field, dir / "m", options);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("poses_bounds.npy: depth is unknown for some views; assumed: from 0.1 m to 100 m"));
}

TEST(LlffFormat, depth_bounds_of_the_file_are_kept) {
  const TempDir dir;
  LightField field = turned_views(2);
  field.depth.reset();
  field.depth_bounds_mm = {{1500.0, 2500.0}, {1.25, 1e6}};
  llff_format().write(field, dir / "m", {});
  const LightField back = llff_format().read(dir / "m", {});
  EXPECT_EQ(back.depth_bounds_mm, field.depth_bounds_mm);
  field.depth = turned_views(2).depth;
  llff_format().write(field, dir / "n", {});
  EXPECT_EQ(llff_format().read(dir / "n", {}).depth_bounds_mm, std::vector<Vec2d>(2, Vec2d(2000.0)))
      << "known depth takes precedence";
}

TEST(LlffFormat, shifted_sensors_and_oblong_pixels_are_refused) {
  EXPECT_THAT(
      error_message([] { encode_llff_poses(posed_cameras(six_views(), "a"), std::vector<Vec2d>(6), "folder"); }),
      AllOf(HasSubstr("view 0"), HasSubstr("-40 x"), HasSubstr("the format llff cannot"), HasSubstr("format nerf or colmap")));
  PosedCamera oblong = turned_views().poses->at(0);
  oblong.focal_px.y = 60.0;
  EXPECT_THAT(error_message([&] {
                encode_llff_poses({oblong}, {{1, 2}}, "folder");
              }),
              AllOf(HasSubstr("not square"), testing::Not(HasSubstr("`"))));
}

TEST(LlffFormat, rows_that_make_no_cameras_are_refused) {
  const auto refusal = [](std::size_t at, double value) {
    std::vector<double> row{0, 1, 0, 0, 30, -1, 0, 0, 0, 40, 0, 0, 1, 2, 50, 1.5, 2.5};
    row[at] = value;
    return error_message([&] { parse_llff_poses(encode_npy(std::span<const double>(row), {1, 17}), "p.npy"); });
  };
  EXPECT_THAT(refusal(3, NAN), AllOf(HasSubstr("p.npy: row 0"), HasSubstr("nan")));
  EXPECT_THAT(refusal(16, INFINITY), AllOf(HasSubstr("p.npy: row 0"), HasSubstr("inf")));
  EXPECT_THAT(refusal(1, -1.0), HasSubstr("left-handed"));
  EXPECT_THAT(refusal(4, 30.5), HasSubstr("30.5"));
  EXPECT_THAT(refusal(14, 0.0), HasSubstr("focal length"));
  const std::vector<double> short_row(16);
  EXPECT_THAT(error_message([&] {
                parse_llff_poses(encode_npy(std::span<const double>(short_row), {1, 16}), "p.npy");
              }),
              HasSubstr("17 numbers"));
}

}  // namespace
}  // namespace lippmann

// Tests that values which no camera can have are one error that names the file, the entry and what would be accepted.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "core/npy.hpp"
#include "formats/colmap_model.hpp"
#include "formats/cvkit_camera.hpp"
#include "formats/hci_parameters.hpp"
#include "formats/llff_poses.hpp"
#include "formats/miv_cameras.hpp"
#include "formats/transforms_json.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/formats/formats.hpp"
#include "support/error_message.hpp"
#include "support/file_bytes.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::json;
using test::error_message, test::numbered_field, test::TempDir;
using testing::AllOf, testing::HasSubstr, testing::StartsWith;

/// Returns the message for the second camera of a cameras.json, with a changed value.
std::string miv_refusal(const char* key, const Json& value) {
  const Json camera{{"Name", "a"},           {"Position", {0, 0, 0}},      {"Rotation", {0, 0, 0}},
                    {"Depth_range", {1, 3}}, {"Resolution", {4, 3}},       {"Projection", "Perspective"},
                    {"Focal", {50, 50}},     {"Principle_point", {2, 1.5}}};
  Json other = camera;
  other["Name"] = "b", other[key] = value;
  const Json file{{"cameras", {camera, other}}};
  return error_message([&] { parse_miv_cameras(file.dump(), "cameras.json"); });
}

TEST(BadMivCameras, depth_range_begins_at_the_nearest_depth) {
  EXPECT_EQ(miv_refusal("Depth_range", {3, 1}),
            "cameras.json: cameras[1].Depth_range: is 3 to 1; accepted: the nearest depth, then the farthest");
  EXPECT_THAT(miv_refusal("Depth_range", {2, 2}), HasSubstr("cameras[1].Depth_range: is 2 to 2"));
  EXPECT_THAT(miv_refusal("Depth_range", {0, 1}), HasSubstr("cameras[1].Depth_range"));
  EXPECT_THAT(miv_refusal("BitDepthDepth", 10.5), HasSubstr("cameras[1].BitDepthDepth: is 10.5"));
}

/// Four views with a wall 250 mm behind the plane of the display.
LightField views_with_depth() {
  LightField field = numbered_field({4, 1}, {6, 5});
  field.cameras = {500.0, Vec2d(0.5), Vec2d(3.0, 2.5), {{-30.0, 0.0}, {-10.0, 0.0}, {10.0, 0.0}, {30.0, 0.0}}};
  field.depth = Image(6, 20, 1);
  for (float& z : field.depth->data) z = -250.0f;
  return field;
}

TEST(BadMivCameras, depth_codes_have_16_bits) {
  const TempDir dir;
  miv_format().write(views_with_depth(), dir / "m", {});
  std::string text = test::file_bytes(dir / "m/cameras.json");
  const std::string bits = "\"BitDepthDepth\": 16";
  text.replace(text.rfind(bits), bits.size(), "\"BitDepthDepth\": 10");
  std::ofstream(dir / "m/cameras.json") << text;
  EXPECT_THAT(error_message([&] { miv_format().read(dir / "m", {}); }),
              AllOf(HasSubstr("cameras.json: the BitDepthDepth of camera view_003 is 10"), HasSubstr("accepted: 16")));
  for (int view = 0; view < 4; ++view) std::filesystem::remove(dir / ("m/view_00" + std::to_string(view) + "_depth.png"));
  EXPECT_FALSE(miv_format().read(dir / "m", {}).depth) << "without depth maps, their number of bits does not matter";
}

TEST(BadLlffCameras, depths_are_above_zero_and_in_order) {
  const auto refusal = [](double nearest, double farthest) {
    const std::vector<double> row{0, 1, 0, 0, 30, -1, 0, 0, 0, 40, 0, 0, 1, 2, 50, nearest, farthest};
    return error_message([&] { parse_llff_poses(encode_npy(std::span<const double>(row), {1, 17}), "p.npy"); });
  };
  EXPECT_EQ(refusal(0, 2),
            "p.npy: row 0: its depths reach from 0 to 2; accepted: the nearest depth, above 0, then the farthest");
  EXPECT_THAT(refusal(-1, 2), HasSubstr("from -1 to 2"));
  EXPECT_THAT(refusal(3, 2), HasSubstr("from 3 to 2"));
  EXPECT_EQ(refusal(2, 2), "(no Error)") << "a wall that faces the camera";
}

TEST(BadColmapCameras, sizes_and_focal_lengths_are_above_zero) {
  const auto refusal = [](const std::string& camera) {
    return error_message([&] { parse_colmap_cameras("# cameras\n" + camera + "\n", "cameras.txt"); });
  };
  EXPECT_EQ(refusal("1 PINHOLE 4 3 -5 5 2 1"), "cameras.txt:2: its focal length is -5; accepted: a number of pixels above 0");
  EXPECT_THAT(refusal("1 PINHOLE 4 3 5 0 2 1"), HasSubstr("its focal length is 0"));
  EXPECT_THAT(refusal("1 PINHOLE 0 3 5 5 2 1"), HasSubstr("cameras.txt:2: its width is 0"));
  EXPECT_THAT(refusal("1 PINHOLE 4 0 5 5 2 1"), HasSubstr("its height is 0"));
  EXPECT_THAT(refusal("1 PINHOLE -4 3 5 5 2 1"), HasSubstr("its width is '-4'"));
}

TEST(BadNerfCameras, sizes_and_focal_lengths_are_above_zero) {
  const auto refusal = [](const char* key, double value) {
    Json file{{"w", 4}, {"h", 3}, {"fl_x", 5}, {"frames", Json::array()}};
    file["frames"].push_back({{"file_path", "a.png"}, {"transform_matrix", {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 2}}}});
    file["frames"][0][key] = value;
    return error_message([&] { parse_transforms(file.dump(), "transforms.json"); });
  };
  EXPECT_EQ(refusal("fl_x", 6.0), "(no Error)");
  for (const char* key : {"fl_x", "fl_y", "w", "h"})
    for (const double value : {0.0, -5.0})
      EXPECT_THAT(refusal(key, value), StartsWith(std::string("transforms.json: frames[0].") + key + ": is ")) << value;
}

TEST(BadCvkitCameras, baseline_is_above_zero) {
  const auto refusal = [](const std::string& lines) {
    return error_message([&] { parse_cvkit_camera("camera.A=[50 0 2; 0 50 1; 0 0 1]\nrho=5\n" + lines, "a_param.txt"); });
  };
  EXPECT_EQ(refusal("t=0.1\n"), "(no Error)");
  EXPECT_EQ(refusal("t=0\n"), "a_param.txt: its t is '0'; accepted: a distance between cameras above 0");
  EXPECT_THAT(refusal("t=-0.1\n"), HasSubstr("its t is '-0.1'"));
  EXPECT_THAT(refusal("t=far\n"), HasSubstr("its t is 'far'"));
}

TEST(BadHciCameras, grid_and_baseline_are_above_zero) {
  const auto refusal = [](const std::string& columns, const std::string& baseline) {
    const std::string text =
        "focal_length_mm = 100\nsensor_size_mm = 35\nimage_resolution_x_px = 4\nimage_resolution_y_px = 3\n"
        "focus_distance_m = 2\nnum_cams_y = 1\nnum_cams_x = " +
        columns + "\nbaseline_mm = " + baseline + "\n";
    return error_message([&] { parse_hci_parameters(text, "parameters.cfg"); });
  };
  EXPECT_EQ(refusal("9", "6"), "(no Error)");
  EXPECT_EQ(refusal("1", "0"), "(no Error)") << "one camera has no baseline";
  EXPECT_EQ(refusal("9", "0"), "parameters.cfg: its baseline_mm is 0, but it has 9x1 cameras; accepted: a number above 0");
  EXPECT_THAT(refusal("9", "-6"), HasSubstr("its baseline_mm is '-6'"));
  EXPECT_THAT(refusal("0", "6"), HasSubstr("its num_cams_x is '0'"));
  EXPECT_EQ(refusal("2.5", "6"), "parameters.cfg: its num_cams_x is 2.5; accepted: a whole number");
}

}  // namespace
}  // namespace lippmann

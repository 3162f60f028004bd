// Tests that readers of folders name data that is missing, or that contradicts other data.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <numbers>

#include "core/regular_file.hpp"
#include "formats/stated_cameras.hpp"
#include "image/png.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/subset.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message, test::numbered_field, test::TempDir;
using testing::AllOf, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::Not;

/// Returns views of 3 x 3 eyes that are 20 mm apart, 500 mm in front of a plane in which pixels are 0.5 mm wide.
LightField nine_views() {
  LightField field = numbered_field({3, 3}, {8, 6});
  field.cameras = {500.0, Vec2d(0.5), Vec2d(4.0, 3.0), {}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) field.cameras->eyes_mm.emplace_back(20.0 * column - 20.0, 20.0 * row - 20.0);
  field.depth = Image(8, 6 * 9, 1);
  for (float& z : field.depth->data) z = -250.0f;
  return field;
}

struct Read {
  LightField field;
  std::vector<std::string> warnings;
};

Read read(const char* format, const fs::path& folder) {
  Read result;
  FormatOptions options;
  options.with_depth = true;
  options.warn = [&](std::string_view text) { result.warnings.emplace_back(text); };
  result.field = find_format(format, "from").read(folder, options);
  return result;
}

/// Writes nine views in a format, and removes files of the folder.
struct Damaged {
  Damaged(const char* format, std::initializer_list<const char*> removed) {
    find_format(format, "to").write(nine_views(), dir / "in", {});
    for (const char* file : removed) EXPECT_TRUE(fs::remove(dir / "in" / file)) << file;
  }
  void replace(const char* file, const std::string& part, const std::string& other) const {
    std::string text = read_file_text(dir / "in" / file, 1 << 20);
    ASSERT_NE(text.find(part), std::string::npos) << part;
    text.replace(text.find(part), part.size(), other);
    std::ofstream(dir / "in" / file) << text;
  }
  std::string refusal(const char* format) const {
    return error_message([&] { read(format, dir / "in"); });
  }
  TempDir dir;
};

TEST(LostViews, first_missing_file_and_count_are_named) {
  EXPECT_THAT(Damaged("hci", {"input_Cam004.png"}).refusal("hci"), HasSubstr("in: input_Cam004.png is missing; accepted"));
  EXPECT_THAT(Damaged("hci", {"input_Cam000.png", "input_Cam007.png", "input_Cam008.png"}).refusal("hci"),
              HasSubstr("input_Cam000.png is missing, and 2 more of 9 views"));
  EXPECT_THAT(Damaged("hci", {"input_Cam008.png"}).refusal("hci"), HasSubstr("input_Cam008.png is missing"))
      << "parameters.cfg states 9 cameras";
  EXPECT_THAT(Damaged("views", {"view_002.png", "view_005.png"}).refusal("views"),
              HasSubstr("view_002.png is missing, and 1 more of 9 views"));
}

TEST(LostViews, sizes_that_disagree_with_pictures_are_refused) {
  const Damaged hci("hci", {});
  hci.replace("parameters.cfg", "image_resolution_x_px = 8", "image_resolution_x_px = 9");
  EXPECT_THAT(hci.refusal("hci"), AllOf(HasSubstr("parameters.cfg"), HasSubstr("image_resolution_x_px"), HasSubstr("9 and 6"),
                                        HasSubstr("input_Cam006.png has 8x6")));
  const Damaged stanford("stanford", {});
  stanford.replace("parameters.cfg", "image_resolution_y_px = 6", "image_resolution_y_px = 60");
  EXPECT_THAT(stanford.refusal("stanford"), HasSubstr("8 and 60, but out_02_00"));
  const Damaged miv("miv", {});
  miv.replace("cameras.json", "\"Resolution\": [\n        8,", "\"Resolution\": [\n        80,");
  EXPECT_THAT(miv.refusal("miv"), AllOf(HasSubstr("cameras.json"), HasSubstr("Resolution of camera view_000 is 80x6"),
                                        HasSubstr("view_000.png has 8x6")));
  const Damaged cvkit("cvkit", {});
  cvkit.replace("view_003_param.txt", "camera.width=8", "camera.width=7");
  EXPECT_THAT(cvkit.refusal("cvkit"), AllOf(HasSubstr("view_003_param.txt"),
                                            HasSubstr("camera.width and camera.height are 7 and 6"), HasSubstr("8x6")));
}

TEST(LostCameras, pictures_without_a_camera_are_named) {
  const Damaged cvkit("cvkit", {"view_004_param.txt"});
  EXPECT_THAT(read("cvkit", cvkit.dir / "in").warnings,
              ElementsAre(AllOf(HasSubstr("NAME_param.txt"), HasSubstr("left out: view_004.png"))));
  const Damaged miv("miv", {});
  miv.replace("cameras.json", "\"Name\": \"view_004\"", "\"Name\": \"viewport\"");
  EXPECT_THAT(read("miv", miv.dir / "in").warnings,
              ElementsAre(AllOf(HasSubstr("cameras.json"), HasSubstr("left out: view_004.png"))));
  const Damaged colmap("colmap", {});
  colmap.replace("sparse/0/images.txt", "004.png\n\n", "004.png\n");
  const std::string text = read_file_text(colmap.dir / "in/sparse/0/images.txt", 1 << 20);
  const std::size_t end = text.find("004.png\n"), begin = text.rfind('\n', end);
  std::ofstream(colmap.dir / "in/sparse/0/images.txt") << text.substr(0, begin) << text.substr(end + 7);
  EXPECT_THAT(read("colmap", colmap.dir / "in").warnings,
              ElementsAre(AllOf(HasSubstr("images.txt"), HasSubstr("left out: 004.png")), HasSubstr("column 1, row 1")));
}

TEST(LostCameras, holes_in_a_grid_are_named) {
  const Damaged cvkit("cvkit", {"view_005.png", "view_005_param.txt", "view_005_disp.pfm"});
  const Read hole = read("cvkit", cvkit.dir / "in");
  EXPECT_THAT(hole.warnings,
              ElementsAre(AllOf(HasSubstr("column 2, row 1"), HasSubstr("the 8 views do not form a grid of 3x3"))));
  EXPECT_EQ(hole.field.grid, (ViewGrid{8, 1}));
  for (const char* format : {"miv", "cvkit", "colmap", "nerf"}) {
    const Damaged whole(format, {});
    EXPECT_THAT(read(format, whole.dir / "in").warnings, IsEmpty()) << format;
  }
}

std::vector<std::string> warnings_about(const std::vector<Vec2d>& eyes) {
  std::vector<std::string> warnings;
  FormatOptions options;
  options.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  warn_of_missing_cameras(eyes, "c", options);
  return warnings;
}

TEST(LostCameras, only_grids_can_have_holes) {
  EXPECT_THAT(warnings_about({{0, 0}, {1, 0}, {3, 0}}), ElementsAre(HasSubstr("column 2, row 0")));
  EXPECT_THAT(warnings_about({{0, 0}, {1, 0}, {0, 1}}), ElementsAre(HasSubstr("column 1, row 1")));
  EXPECT_THAT(warnings_about({{0, 0}, {1.001, 0}, {2, 0.001}}), IsEmpty()) << "not exactly regular";
  EXPECT_THAT(warnings_about({{0, 0}, {2, 0}, {1, 1}, {3, 1}}), IsEmpty()) << "half a step between rows";
  EXPECT_THAT(warnings_about({{1, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 2}}), IsEmpty()) << "a cross";
  EXPECT_THAT(warnings_about({{0, 0}, {1, 0}, {2.5, 0}}), IsEmpty()) << "irregular";
  EXPECT_THAT(warnings_about({{1, 2}, {1, 2}}), IsEmpty()) << "one place";
}

TEST(LostDepth, missing_map_is_named) {
  const auto warnings_of = [](const char* format, std::initializer_list<const char*> removed) {
    const Damaged damaged(format, removed);
    const Read result = read(format, damaged.dir / "in");
    EXPECT_FALSE(result.field.depth) << format;
    EXPECT_TRUE(result.field.lacks_some_depth) << format;
    return result.warnings;
  };
  EXPECT_THAT(warnings_of("hci", {"gt_depth_lowres_Cam007.pfm", "gt_disp_lowres_Cam007.pfm"}),
              ElementsAre(HasSubstr("gt_depth_lowres_Cam007.pfm is missing, so the depth of all views is left out")));
  EXPECT_THAT(warnings_of("cvkit", {"view_003_disp.pfm", "view_005_disp.pfm"}),
              ElementsAre(HasSubstr("view_003_disp.pfm and 1 more of 9 depth maps are missing")));
  EXPECT_THAT(warnings_of("miv", {"view_008_depth.png"}), ElementsAre(HasSubstr("view_008_depth.png is missing")));
  EXPECT_THAT(warnings_of("nerf", {"depth/002.npy"}), ElementsAre(HasSubstr("'depth/002.npy' is missing")));
  const Damaged cvkit("cvkit", {});
  cvkit.replace("view_001_param.txt", "rho=", "# rho=");
  EXPECT_THAT(read("cvkit", cvkit.dir / "in").warnings, ElementsAre(HasSubstr("view_001_param.txt states no rho")));
  const Damaged nerf("nerf", {});
  nerf.replace("transforms.json", "\"depth_file_path\": \"depth/000.npy\",", "");
  EXPECT_THAT(read("nerf", nerf.dir / "in").warnings, ElementsAre(HasSubstr("frames[0]: has no depth file")));
}

TEST(LostDepth, folders_without_depth_give_no_warning) {
  for (const char* format : {"hci", "cvkit", "miv", "nerf"}) {
    const TempDir dir;
    LightField field = nine_views();
    field.depth.reset();
    find_format(format, "to").write(field, dir / "in", {});
    const Read result = read(format, dir / "in");
    EXPECT_THAT(result.warnings, IsEmpty()) << format;
    EXPECT_FALSE(result.field.lacks_some_depth) << format;
  }
}

TEST(LostDepth, conversion_warns_once) {
  const Damaged hci("hci", {"gt_depth_lowres_Cam007.pfm", "gt_disp_lowres_Cam007.pfm"});
  const Converted converted = convert(hci.dir / "in", hci.dir / "out", {.from = "hci", .to = "miv"});
  EXPECT_FALSE(converted.lacks_depth) << "the reader has warned";
}

/// Readers that resize the views must not compare the resized views with depth maps and cameras.
TEST(LostDepth, resized_views_need_no_depth) {
  for (const char* format : {"hci", "cvkit", "miv", "stanford"}) {
    const Damaged whole(format, {});
    FormatOptions options;
    options.fit_view = [](const Picture&, double, int, ViewGrid) { return Picture(Image8{1, 1, {1, 2, 3}}); };
    const LightField field = find_format(format, "from").read(whole.dir / "in", options);
    EXPECT_EQ(field.view_size, Vec2i(1)) << format;
    EXPECT_FALSE(field.depth || field.cameras) << format;
  }
}

void remove_maps(const fs::path& folder, const std::function<bool(const std::string&)>& is_removed) {
  std::vector<fs::path> removed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".pfm" && is_removed(entry.path().filename().string())) removed.push_back(entry.path());
  for (const fs::path& path : removed) fs::remove(path);
}

TEST(HciDepth, depth_of_one_view_is_kept) {
  const auto expect_kept = [](const std::function<bool(const std::string&)>& is_removed, int view, const char* map) {
    const Damaged whole("hci", {});
    remove_maps(whole.dir / "in", is_removed);
    const Read before = read("hci", whole.dir / "in");
    EXPECT_THAT(before.warnings, IsEmpty()) << map;
    EXPECT_FALSE(before.field.depth) << map;
    ASSERT_TRUE(before.field.view_depth) << map;
    EXPECT_EQ(before.field.view_depth->view, view) << map;
    EXPECT_NEAR(before.field.view_depth->depth.data[0], -250.0f, 1e-2) << map;
    const Converted converted = convert(whole.dir / "in", whole.dir / "out", {.from = "hci", .to = "hci"});
    EXPECT_THAT(converted.left_out, IsEmpty()) << map;
    EXPECT_FALSE(converted.lacks_depth) << map;
    EXPECT_TRUE(is_regular_file_there(whole.dir / "out" / map)) << map;
    EXPECT_THAT(convert(whole.dir / "in", whole.dir / "miv", {.from = "hci", .to = "miv"}).left_out,
                ElementsAre("the depth of one view"));
  };
  // The middle view of 3 x 3 views is view 4. View 0 is the lower left one, number 6 from the top left.
  expect_kept([](const std::string& name) { return name.find("_Cam") != std::string::npos; }, 4, "gt_depth_lowres.pfm");
  expect_kept([](const std::string& name) { return name != "gt_disp_lowres.pfm"; }, 4, "gt_disp_lowres.pfm");
  expect_kept([](const std::string& name) { return name != "gt_depth_lowres_Cam006.pfm"; }, 0, "gt_depth_lowres_Cam006.pfm");
}

TEST(HciDepth, disparity_replaces_missing_depth) {
  const Damaged whole("hci", {});
  remove_maps(whole.dir / "in", [](const std::string& name) { return name.starts_with("gt_depth"); });
  const LightField field = read("hci", whole.dir / "in").field;
  ASSERT_TRUE(field.depth);
  for (const float z : field.depth->data) ASSERT_NEAR(z, -250.0f, 1e-2);
}

TEST(HciDepth, subset_moves_the_depth_of_one_view) {
  LightField field = nine_views();
  field.view_depth = ViewDepth{4, depth_of(field, 4)};
  field.depth.reset();
  LightField corner = field;
  keep(corner, read_kept_views("1-2x1-2", "keep"), "keep");
  ASSERT_TRUE(corner.view_depth);
  EXPECT_EQ(corner.view_depth->view, 0);
  keep(corner, read_kept_views("1x1", "keep"), "keep");
  EXPECT_FALSE(corner.view_depth) << "its view is not kept";
  crop(field, read_crop("3x2+1+1", "crop"), "crop");
  EXPECT_EQ(field.view_depth->depth.data.size(), 6u);
}

/// Returns views with notes as in a data set of HCI.
LightField noted_views() {
  LightField field = nine_views();
  field.hci = HciNotes{.centre_camera_m = Vec3d(1.5, -2.0, 3.0),
                       .centre_camera_rad = Vec3d(0.0, 0.0, 0.5 * std::numbers::pi),
                       .scene = "cotton",
                       .category = "training",
                       .authors = "Ada",
                       .disparity_px = {-1.5, 2.0},
                       .frustum_disparity_px = {-3.0, 4.0},
                       .depth_map_scale = 10.0};
  return field;
}

TEST(HciNotes, entries_are_kept_or_named) {
  const TempDir dir;
  hci_format().write(noted_views(), dir / "in", {});
  const std::string before = read_file_text(dir / "in/parameters.cfg", 1 << 20);
  for (const char* line : {"center_cam_y_m = -2\n", "center_cam_rz_rad = 1.57", "scene = cotton\n", "category = training\n",
                           "authors = Ada\n", "disp_min = -1.5\n", "frustum_disp_max = 4\n", "depth_map_scale = 10\n"})
    EXPECT_THAT(before, HasSubstr(line));
  EXPECT_THAT(convert(dir / "in", dir / "out", {.from = "hci", .to = "hci"}).left_out, IsEmpty());
  EXPECT_EQ(read_file_text(dir / "out/parameters.cfg", 1 << 20), before);
  EXPECT_THAT(convert(dir / "in", dir / "miv", {.from = "hci", .to = "miv"}).left_out,
              ElementsAre("entries of parameters.cfg: center_cam, category, authors"));
}

TEST(HciNotes, usual_entries_are_not_named) {
  const Damaged hci("hci", {});
  EXPECT_THAT(convert(hci.dir / "in", hci.dir / "miv", {.from = "hci", .to = "miv"}).left_out, IsEmpty());
}

/// The middle of the kept cameras is 10 mm to the right and 10 mm above that of all cameras. Cameras that are turned by 90
/// degrees about z have their x axis along the y axis of the scene.
TEST(HciNotes, subset_moves_the_centre_and_scales_disparities) {
  const TempDir dir;
  hci_format().write(noted_views(), dir / "in", {});
  const HciNotes before = noted_views().hci.value();
  ConvertParams params{.from = "hci", .to = "hci"};
  params.keep = read_kept_views("1-2x1-2", "keep");
  EXPECT_THAT(convert(dir / "in", dir / "out", params).left_out, ElementsAre(HasSubstr("20 x 20 pixels off the axes")));
  const Vec3d moved = read("hci", dir / "out").field.hci->centre_camera_m.value() - before.centre_camera_m.value();
  EXPECT_LT(glm::distance(moved, Vec3d(-0.01, 0.01, 0.0)), 1e-9);
  params.keep = read_kept_views("0-2:2x0-2:2", "keep");
  convert(dir / "in", dir / "half", params);
  const HciNotes half = read("hci", dir / "half").field.hci.value();
  EXPECT_EQ(half.centre_camera_m, before.centre_camera_m);
  EXPECT_EQ(half.disparity_px, 2.0 * before.disparity_px);
  EXPECT_EQ(half.frustum_disparity_px, 2.0 * before.frustum_disparity_px);
}

TEST(PixelAspect, follows_cameras_and_side_files) {
  const TempDir dir;
  LightField field = nine_views();
  field.cameras->pixel_mm = {1.0, 0.5}, field.aspect = 2.0 * 8 / 6;
  for (const char* format : {"miv", "cvkit", "nerf", "colmap", "views"}) {
    find_format(format, "to").write(field, dir / format, {});
    EXPECT_NEAR(pixel_aspect(read(format, dir / format).field), 2.0, 1e-9) << format;
  }
  find_format("views", "to").write(nine_views(), dir / "views", {});
  EXPECT_EQ(pixel_aspect(read("views", dir / "views").field), 1.0) << "an earlier side file is replaced";
  std::ofstream(dir / "views/views.json") << R"({"views": {"pixel_aspect": 0}})";
  EXPECT_THAT(error_message([&] { read("views", dir / "views"); }), HasSubstr("views.json: views.pixel_aspect"));
  std::ofstream(dir / "views/views.json") << R"({"mine": 3})";
  EXPECT_EQ(pixel_aspect(read("views", dir / "views").field), 1.0);
}

}  // namespace
}  // namespace lippmann

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "formats/eslf_side_file.hpp"
#include "formats/stated_cameras.hpp"
#include "image/netpbm.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message, test::numbered_field, test::TempDir;
using testing::HasSubstr;

constexpr StatedCameras kTrial{
    .baseline_mm = 100.0, .focal_length_mm = 100.0, .sensor_width_mm = 35.0, .focus_distance_mm = 8000.0};

ConvertParams stated(const char* from, const char* to, StatedCameras cameras = kTrial) {
  ConvertParams params;
  params.from = from, params.to = to, params.options.cameras = cameras;
  return params;
}

/// Writes three HCI views in a row without parameters.cfg. Pixel 0 has a depth of 4 m, pixel 1 of 8 m, and pixel 2
/// shows no surface.
void write_trial(const fs::path& folder) {
  hci_format().write(numbered_field({3, 1}, {512, 1}), folder, {});
  Image depth(512, 1, 1);
  std::fill(depth.data.begin(), depth.data.end(), 8.0f);
  depth.data[0] = 4.0f, depth.data[2] = INFINITY, depth.data[3] = 1e9f;
  for (int view = 0; view < 3; ++view) write_pfm(folder / ("gt_depth_lowres_Cam00" + std::to_string(view) + ".pfm"), depth);
}

TEST(StatedCameras, disparities_follow_from_the_flags) {
  const TempDir dir;
  write_trial(dir / "in");
  ConvertParams params = stated("hci", "hci");
  params.options.views = ViewGrid{3, 1};
  convert(dir / "in", dir / "out", params);
  // Disparity: (b f n / s) (1 / Z - 1 / F), with the baseline b = 100 mm, the focal length f = 100 mm, n = 512 pixels
  // across the sensor of s = 35 mm, the depth Z and the focus distance F = 8000 mm.
  const Image disparity = read_pfm(dir / "out/gt_disp_lowres_Cam001.pfm");
  EXPECT_NEAR(disparity.data[0], 18.2857, 1e-4);
  EXPECT_NEAR(disparity.data[1], 0.0, 1e-4);
  EXPECT_EQ(disparity.data[2], -INFINITY);
  EXPECT_NEAR(disparity.data[3], -18.2857, 1e-4);
}

TEST(StatedCameras, every_second_view_doubles_disparities) {
  const TempDir dir;
  write_trial(dir / "in");
  ConvertParams params = stated("hci", "hci");
  params.options.views = ViewGrid{3, 1};
  params.keep = read_kept_views("0-2:2", "--keep");
  convert(dir / "in", dir / "out", params);
  const Image disparity = read_pfm(dir / "out/gt_disp_lowres_Cam001.pfm");
  EXPECT_NEAR(disparity.data[0], 36.5714, 1e-4);
  EXPECT_NEAR(disparity.data[3], -36.5714, 1e-4);
}

TEST(StatedCameras, sensor_width_is_that_of_portrait_views) {
  LightField field = numbered_field({2, 1}, {10, 40});
  const ViewCameras cameras = cameras_as_stated(kTrial, field, "a");
  EXPECT_NEAR(cameras.pixel_mm.x, 35.0 * 8000.0 / (100.0 * 10.0), 1e-9);
  EXPECT_DOUBLE_EQ(cameras.pixel_mm.y, cameras.pixel_mm.x);
}

TEST(StatedCameras, files_that_state_cameras_refuse_them) {
  const TempDir dir;
  LightField field = numbered_field({3, 1}, {4, 4});
  field.cameras = cameras_as_stated(kTrial, field, "a");
  hci_format().write(field, dir / "in", {});
  EXPECT_THAT(error_message([&] { convert(dir / "in", dir / "out", stated("hci", "miv")); }),
              testing::AllOf(HasSubstr("baseline"), HasSubstr("states its cameras")));
}

TEST(StatedCameras, lengths_must_be_positive) {
  const LightField field = numbered_field({2, 1}, {4, 4});
  for (double StatedCameras::*length : {&StatedCameras::baseline_mm, &StatedCameras::focal_length_mm,
                                        &StatedCameras::sensor_width_mm, &StatedCameras::focus_distance_mm})
    for (const double bad : {0.0, -1.0, std::nan(""), static_cast<double>(INFINITY)}) {
      StatedCameras cameras = kTrial;
      cameras.*length = bad;
      EXPECT_THROW(cameras_as_stated(cameras, field, "a"), Error) << bad;
    }
}

/// Returns 2 x 2 views at irregular positions whose x decreases from left to right.
LightField irregular_field() {
  LightField field = numbered_field({2, 2}, {4, 4});
  field.positions = std::vector<Vec2d>{{10.0, -776.88}, {0.0, -776.0}, {10.5, -770.123456789}, {1.5, -770.0}};
  return field;
}

TEST(StanfordFormat, positions_come_back_exactly) {
  const TempDir dir;
  const LightField field = irregular_field();
  stanford_format().write(field, dir / "a", {});
  EXPECT_TRUE(fs::exists(dir / "a/out_01_00_776.880000_10.000000.png"));
  convert(dir / "a", dir / "b", [] {
    ConvertParams params;
    params.from = params.to = "stanford";
    return params;
  }());
  EXPECT_EQ(stanford_format().read(dir / "b", {}).positions, field.positions);
}

TEST(StanfordFormat, irregular_cameras_have_the_mean_baseline) {
  const TempDir dir;
  stanford_format().write(irregular_field(), dir / "a", {});
  convert(dir / "a", dir / "b", stated("stanford", "stanford"));
  const LightField read = stanford_format().read(dir / "b", {});
  EXPECT_EQ(read.positions, irregular_field().positions);
  ASSERT_TRUE(read.cameras);
  EXPECT_NEAR(read.cameras->distance_mm, 8000.0, 1e-9);
  const std::vector<Vec2d>& eyes = read.cameras->eyes_mm;
  EXPECT_NEAR(0.5 * (eyes[1].x - eyes[0].x + eyes[3].x - eyes[2].x), 100.0, 1e-9);
  EXPECT_NEAR(eyes[1].x - eyes[0].x, 100.0 * 10.0 / 9.5, 1e-9);
  EXPECT_NEAR(eyes[2].y - eyes[0].y, 100.0 * (776.88 - 770.123456789) / 9.5, 1e-9);
}

TEST(StanfordFormat, equal_positions_have_no_baseline) {
  LightField field = irregular_field();
  field.positions = std::vector<Vec2d>(4, Vec2d(3.0, 4.0));
  EXPECT_THAT(error_message([&] { cameras_as_stated(kTrial, field, "lego"); }),
              testing::AllOf(HasSubstr("lego"), HasSubstr("positions")));
}

TEST(StanfordFormat, one_name_without_a_position_is_an_error) {
  for (const bool has_cameras : {false, true}) {
    const TempDir dir;
    LightField field = irregular_field();
    if (has_cameras) field.cameras = cameras_as_stated(kTrial, field, "a");
    stanford_format().write(field, dir / "s", {});
    EXPECT_EQ(fs::exists(dir / "s/parameters.cfg"), has_cameras);
    fs::path last;
    for (const fs::directory_entry& entry : fs::directory_iterator(dir / "s"))
      if (entry.path().filename().string().starts_with("out_01_01")) last = entry.path();
    const auto refusal = [&](const char* name) {
      fs::rename(last, dir / "s" / name);
      last = dir / "s" / name;
      return error_message([&] { stanford_format().read(dir / "s", {}); });
    };
    EXPECT_THAT(refusal("out_01_01_nan_2.5.png"),
                testing::AllOf(HasSubstr("out_01_01_nan_2.5.png: y in its name is nan"), HasSubstr("accepted: a number")));
    EXPECT_THAT(refusal("out_01_01_2.5_1.2.3.png"), HasSubstr("x in its name is 1.2.3"));
    EXPECT_THAT(refusal("out_01_01_2_inf_.png"), HasSubstr("x in its name is inf"));
    EXPECT_THAT(refusal("out_01_01.png"), HasSubstr("out_01_01.png: its name has no y and x"));
  }
}

TEST(StanfordFormat, names_may_have_no_positions) {
  const TempDir dir;
  stanford_format().write(numbered_field({2, 1}, {4, 4}), dir / "s", {});
  fs::rename(dir / "s/out_00_00_0.000000_0.000000.png", dir / "s/out_00_00.png");
  fs::rename(dir / "s/out_00_01_0.000000_1.000000.png", dir / "s/out_00_01.png");
  EXPECT_FALSE(stanford_format().read(dir / "s", {}).positions);
}

TEST(EslfFormat, side_file_keeps_positions_and_cameras) {
  const TempDir dir;
  LightField field = irregular_field();
  field.cameras = cameras_as_stated(kTrial, field, "a");
  eslf_format().write(field, dir / "a.png", {});
  const OpenedLightField read = open_light_field(dir / "a.png", "", {});
  EXPECT_EQ(read.format, "eslf");
  EXPECT_TRUE(test::same_samples(read.field.stack, field.stack));
  EXPECT_EQ(read.field.positions, field.positions);
  ASSERT_TRUE(read.field.cameras);
  EXPECT_EQ(read.field.cameras->eyes_mm, field.cameras->eyes_mm);
  EXPECT_EQ(read.field.cameras->pixel_mm, field.cameras->pixel_mm);
  EXPECT_EQ(read.field.cameras->centre_px, field.cameras->centre_px);
  EXPECT_EQ(read.field.cameras->distance_mm, 8000.0);
  EXPECT_THAT(error_message([&] { eslf_format().read(dir / "a.png", {.views = ViewGrid{4, 1}}); }), HasSubstr("2x2"));
}

TEST(EslfFormat, side_file_states_the_views_without_cameras) {
  const TempDir dir;
  const LightField field = numbered_field({3, 2}, {4, 4});
  EXPECT_THAT(eslf_format().write(field, dir / "a.png", {}), testing::ElementsAre(dir / "a.png", dir / "a.png.json"));
  const LightField read = eslf_format().read(dir / "a.png", {});
  EXPECT_EQ(read.grid, field.grid);
  EXPECT_TRUE(test::same_samples(read.stack, field.stack));
  EXPECT_FALSE(read.cameras);
  EXPECT_FALSE(read.positions);
  EXPECT_EQ(pixel_aspect(read), 1.0);
}

TEST(EslfFormat, pixels_of_views_are_square) {
  const TempDir dir;
  const struct {
    ViewGrid grid;
    Vec2i view_size;
  } trials[] = {{{14, 14}, {541, 376}}, {{15, 15}, {625, 434}}, {{9, 5}, {40, 30}}, {{5, 9}, {30, 40}}};
  for (const auto& [grid, size] : trials) {
    write_picture(dir / "a.png",
                  Image8{grid.columns * size.x, grid.rows * size.y,
                         std::vector<unsigned char>(static_cast<std::size_t>(3 * grid.columns * size.x * grid.rows * size.y))});
    const LightField field = eslf_format().read(dir / "a.png", {.views = grid});
    EXPECT_EQ(field.view_size, size);
    EXPECT_EQ(pixel_aspect(field), 1.0) << grid.columns << "x" << grid.rows;
    EXPECT_DOUBLE_EQ(field.aspect, static_cast<double>(size.x) / size.y);
  }
}

TEST(EslfFormat, side_file_keeps_the_shape_of_pixels) {
  const TempDir dir;
  LightField field = numbered_field({4, 2}, {6, 5});
  field.aspect = 2.0 * 6 / 5;
  eslf_format().write(field, dir / "a.png", {});
  EXPECT_DOUBLE_EQ(pixel_aspect(open_light_field(dir / "a.png", "", {}).field), 2.0);
  const auto aspect_in = [](const char* text) { return parse_eslf_side_file(text, "side.json")->pixel_aspect; };
  EXPECT_EQ(aspect_in(R"({"eslf": {"columns": 1, "rows": 1}})"), 1.0);
  EXPECT_EQ(aspect_in(R"({"eslf": {"columns": 1, "rows": 1, "cameras": {"distance_mm": 9, "pixel_mm": [6, 2],
                          "centre_px": [0, 0], "eyes_mm": [[0, 0]]}}})"),
            3.0)
      << "the cameras state it";
  EXPECT_THAT(error_message([&] { aspect_in(R"({"eslf": {"columns": 1, "rows": 1, "pixel_aspect": 0}})"); }),
              HasSubstr("side.json: eslf.pixel_aspect: is 0"));
}

TEST(EslfFormat, damaged_side_files_are_refused) {
  for (const char* text : {R"({"eslf": 3})", R"({"eslf": {"columns": 2}})", R"({"eslf": {"columns": 0, "rows": 1}})",
                           R"({"eslf": {"columns": 2, "rows": 1, "positions": [[1, 2]]}})",
                           R"({"eslf": {"columns": 2, "rows": 1, "positions": [[1, 2], [1]]}})",
                           R"({"eslf": {"columns": 1, "rows": 1, "cameras": {"distance_mm": -1}}})",
                           R"({"eslf": {"columns": 1, "rows": 1, "cameras": {"distance_mm": 1, "pixel_mm": [1, 0]}}})"})
    EXPECT_THAT(error_message([&] { parse_eslf_side_file(text, "side.json"); }), HasSubstr("side.json")) << text;
  EXPECT_FALSE(parse_eslf_side_file(R"({"quilt_settings": {}})", "a"));
}

/// Writes the picture of a plenoptic camera. Red and green are the view's column and row, and blue depends on the pixel
/// within the view.
void write_plenoptic(const fs::path& path, ViewGrid grid, Vec2i view_size) {
  const Vec2i size(grid.columns * view_size.x, grid.rows * view_size.y);
  std::string samples;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      samples += static_cast<char>(x % grid.columns), samples += static_cast<char>(y % grid.rows);
      samples += static_cast<char>(x / grid.columns + y / grid.rows);
    }
  std::ofstream(path, std::ios::binary) << "P6\n" << size.x << ' ' << size.y << "\n255\n" << samples;
}

void expect_plenoptic_views(const LightField& field) {
  const Image8& stack = std::get<Image8>(field.stack);
  std::size_t at = 0, wrong = 0;
  for (int view = 0; view < field.grid.count(); ++view)
    for (int y = 0; y < field.view_size.y; ++y)
      for (int x = 0; x < field.view_size.x; ++x, at += 3)
        wrong += stack.rgb[at] != view % field.grid.columns ||
                 stack.rgb[at + 1] != field.grid.rows - 1 - view / field.grid.columns ||
                 stack.rgb[at + 2] != static_cast<unsigned char>(x + y);
  EXPECT_EQ(wrong, 0u);
}

TEST(EslfFormat, every_view_is_exact) {
  const TempDir dir;
  for (const ViewGrid grid : {ViewGrid{14, 14}, ViewGrid{15, 15}}) {
    write_plenoptic(dir / "a.ppm", grid, {11, 7});
    const LightField field = eslf_format().read(dir / "a.ppm", {.views = grid});
    EXPECT_EQ(field.view_size, Vec2i(11, 7));
    expect_plenoptic_views(field);
  }
}

TEST(EslfFormat, wrong_grid_of_real_cameras_is_refused) {
  const struct {
    ViewGrid grid, wrong;
    Vec2i view_size, size;
  } trials[] = {{{14, 14}, {15, 15}, {541, 376}, {7574, 5264}}, {{15, 15}, {14, 14}, {625, 434}, {9375, 6510}}};
  for (const auto& trial : trials) {
    const ViewLayout right{LayoutKind::kEslf, trial.grid, {}}, wrong{LayoutKind::kEslf, trial.wrong, {}};
    EXPECT_EQ(view_size(right, trial.size, "a"), trial.view_size);
    EXPECT_EQ(picture_size(right, trial.view_size), trial.size);
    EXPECT_THAT(error_message([&] { view_size(wrong, trial.size, "flower.png"); }),
                testing::AllOf(HasSubstr("flower.png"), HasSubstr("cannot be divided")));
    const int bottom_right = trial.grid.columns - 1;
    const ViewPlace place = place_of_view(right, trial.view_size, trial.size, bottom_right);
    EXPECT_EQ(place.first + (trial.view_size.x - 1) * place.across + (trial.view_size.y - 1) * place.down,
              std::ptrdiff_t{trial.size.x} * trial.size.y - 1);
  }
}

}  // namespace
}  // namespace lippmann
